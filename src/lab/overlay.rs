use crate::error::worst_channel;
use eightfold_tracer::observe::{Fill, Observer};
use eightfold_tracer::{Counts, Quality};
use std::sync::LazyLock;
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

pub struct FrameTrace {
    width: usize,
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

    /// Draws white points on the darkened picture.
    pub fn draw_points(&self, pixels: &mut [u32]) {
        for (pixel, rays) in pixels.iter_mut().zip(self.rays()) {
            let dark = (*pixel >> 2) & 0x003f_3f3f;
            *pixel = if rays > 0 { 0x00ff_ffff } else { dark };
        }
    }

    /// Colours squares by size, with dark left and upper edges.
    pub fn draw_squares(&self, pixels: &mut [u32]) {
        for square in self.squares() {
            let colour = square_colour(square.side);
            let dark = (colour >> 1) & 0x007f_7f7f;
            let edge = if square.side > 2 { dark } else { colour };
            for y in square.y..square.y + square.h {
                let row = &mut pixels[y * self.width + square.x..][..square.w];
                row.fill(if y == square.y { edge } else { colour });
                row[0] = edge;
            }
        }
    }

    /// Draws 0 rays black, `most` white.
    pub fn draw_heat(&self, pixels: &mut [u32], most: u32) {
        for (pixel, rays) in pixels.iter_mut().zip(self.rays()) {
            *pixel = heat(rays as f32 / most as f32);
        }
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

/// Small squares, which cost more, are brighter.
pub fn square_colour(side: usize) -> u32 {
    let halvings = (Quality::MAX_SQUARE / side.max(1)).max(1).ilog2();
    heat(0.12 + 0.83 * halvings as f32 / Quality::MAX_SQUARE.ilog2() as f32)
}

/// Replaces pixels with their errors, white for `most` of 255 in a channel.
pub fn draw_error(pixels: &mut [u32], exhaustive: &[u32], most: u32) {
    for (pixel, &exhaustive) in pixels.iter_mut().zip(exhaustive) {
        *pixel = heat(worst_channel(*pixel, exhaustive) as f32 / most as f32);
    }
}

/// Returns a colour of the perceptually uniform "magma", 0 dark to 1 bright.
pub fn heat(share: f32) -> u32 {
    static SCALE: LazyLock<Vec<u32>> = LazyLock::new(|| {
        let bytes = nv_flip::magma_lut().to_vec();
        let colours = bytes.as_chunks().0.iter();
        colours.map(|&[r, g, b]| u32::from_be_bytes([0, r, g, b])).collect()
    });
    SCALE[(share.clamp(0.0, 1.0) * 255.0).round() as usize]
}
