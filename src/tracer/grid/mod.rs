//! The grids of a tile. Level `n` has squares of `1 << n` pixels a side.

mod bits;
mod pyramid;

pub(crate) use bits::{Bits, WORDS, each};
pub(crate) use pyramid::{CHANGES, GridRow, LEVELS, Pyramid};

pub(crate) struct Area {
    pub left: usize,
    pub top: usize,
    pub right: usize,
    pub bottom: usize,
    pub picture: [usize; 2],
}

impl Area {
    /// The last column of squares may extend beyond the picture.
    pub fn columns(&self, level: usize) -> usize {
        (self.right - self.left).div_ceil(1 << level)
    }

    pub fn rows(&self, level: usize) -> usize {
        (self.bottom - self.top).div_ceil(1 << level)
    }
}
