use eightfold_tracer::Counts;
use eightfold_tracer::observe::{Fill, Observer};
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};
use std::sync::{Mutex, PoisonError};

/// Records the points and squares of a frame.
pub struct FrameTrace {
    pub width: usize,
    height: usize,
    /// Each pixel's number of rays, including shadow rays; 0 if it was not traced.
    rays: Vec<AtomicU32>,
    squares: Mutex<Vec<Square>>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Square {
    pub x: usize,
    pub y: usize,
    pub w: usize,
    pub h: usize,
    /// The larger side, unclipped.
    pub side: usize,
    pub fill: Fill,
}

impl FrameTrace {
    pub fn new(width: usize, height: usize) -> Self {
        let rays = (0..width * height).map(|_| AtomicU32::new(0)).collect();
        Self { width, height, rays, squares: Mutex::default() }
    }

    pub fn rays(&self) -> impl Iterator<Item = u32> {
        self.rays.iter().map(|rays| rays.load(Relaxed))
    }

    pub fn squares(&self) -> Vec<Square> {
        self.squares.lock().unwrap_or_else(PoisonError::into_inner).clone()
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
            let side = w.max(h);
            let (w, h) = (w.min(self.width - x), h.min(self.height - y));
            let mut squares = self.squares.lock().unwrap_or_else(PoisonError::into_inner);
            squares.push(Square { x, y, w, h, side, fill });
        }
    }
}
