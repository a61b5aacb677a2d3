//! The grids of a tile: its squares and their corners, level by level.
//!
//! Level `n` has squares of `1 << n` pixels a side; level 0 has pixels. `bits` has a bit for each square or point of a row, and
//! `pyramid` the samples of all points.

mod bits;
mod pyramid;

pub(crate) use bits::{Bits, WORDS, each};
pub(crate) use pyramid::{GridRow, LEVELS, Pyramid, SCRATCH};

/// Where a tile is in the picture, in pixels.
pub(crate) struct Area {
    pub left: usize,
    pub top: usize,
    /// The end of its pixels.
    pub right: usize,
    pub bottom: usize,
    /// Width and height of the picture.
    pub picture: [usize; 2],
}

impl Area {
    /// Squares of a level side by side; the last ones may end beyond the picture.
    pub fn columns(&self, level: usize) -> usize {
        (self.right - self.left).div_ceil(1 << level)
    }

    /// Squares of a level on top of each other.
    pub fn rows(&self, level: usize) -> usize {
        (self.bottom - self.top).div_ceil(1 << level)
    }
}
