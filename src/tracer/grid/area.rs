//! The part of the picture that a tile covers.

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
