use eightfold_tracer::Counts;
use eightfold_tracer::observe::{Fill, Observer};
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

/// Records the points and squares of a frame.
pub struct FrameTrace {
    pub width: usize,
    height: usize,
    /// Per pixel, with shadow rays; 0 without a point.
    rays: Vec<AtomicU32>,
    /// `w << 16 | h << 8 | fill` at upper left corners; otherwise 0.
    squares: Vec<AtomicU32>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Drawn {
    pub x: usize,
    pub y: usize,
    pub w: usize,
    pub h: usize,
    /// The larger side, unclipped.
    pub side: usize,
    pub fill: Fill,
}

/// Numbered from 1.
const FILLS: [Fill; 4] = [Fill::Flat, Fill::Bilinear, Fill::Patterned, Fill::Points];

impl FrameTrace {
    pub fn new(width: usize, height: usize) -> Self {
        let zeros = || (0..width * height).map(|_| AtomicU32::new(0)).collect();
        Self { width, height, rays: zeros(), squares: zeros() }
    }

    pub fn rays(&self) -> impl Iterator<Item = u32> {
        self.rays.iter().map(|rays| rays.load(Relaxed))
    }

    pub fn squares(&self) -> impl Iterator<Item = Drawn> {
        let words = self.squares.iter().map(|word| word.load(Relaxed));
        let squares = words.enumerate().filter(|&(_, word)| word != 0);
        squares.map(|(i, word)| {
            let (x, y) = (i % self.width, i / self.width);
            let [_, w, h, fill] = word.to_be_bytes().map(usize::from);
            Drawn {
                x,
                y,
                w: w.min(self.width - x),
                h: h.min(self.height - y),
                side: w.max(h),
                fill: FILLS[fill - 1],
            }
        })
    }
}

impl Observer for &FrameTrace {
    fn point(self, x: usize, y: usize, work: Counts) {
        if x < self.width && y < self.height {
            let rays = (work.rays + work.shadow_rays) as u32;
            self.rays[y * self.width + x].store(rays, Relaxed);
        }
    }

    fn square(self, x: usize, y: usize, w: usize, h: usize, fill: Fill) {
        if x < self.width && y < self.height {
            let fill = 1 + FILLS.iter().position(|&known| known == fill).unwrap_or(0);
            let word = (w << 16 | h << 8 | fill) as u32;
            self.squares[y * self.width + x].store(word, Relaxed);
        }
    }
}
