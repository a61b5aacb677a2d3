//! The grids of a tile. Level `n` has squares of `1 << n` pixels a side.

mod bits;
mod pyramid;

pub(crate) use bits::{Bits, WORDS, each};
pub(crate) use pyramid::{GridRow, LEVELS, Pyramid, SCRATCH};

/// The pixels of a tile in the picture.
pub(crate) struct Area {
    pub left: usize,
    pub top: usize,
    pub right: usize,
    pub bottom: usize,
    /// The width and height of the picture.
    pub picture: [usize; 2],
}

impl Area {
    /// Returns the number of columns of squares. The last one may extend beyond the picture.
    pub fn columns(&self, level: usize) -> usize {
        (self.right - self.left).div_ceil(1 << level)
    }

    pub fn rows(&self, level: usize) -> usize {
        (self.bottom - self.top).div_ceil(1 << level)
    }
}
