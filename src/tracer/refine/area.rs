//! The part of the picture that a tile covers.

/// Where a tile is in the picture, in pixels.
pub(super) struct Area {
    pub left: usize,
    pub top: usize,
    /// The end of its pixels.
    pub right: usize,
    pub bottom: usize,
    /// Width and height of the picture.
    pub picture: [usize; 2],
    /// Side of the smallest squares that are more than a pixel: see [`Quality::least_square`](crate::Quality::least_square).
    pub least: usize,
}

impl Area {
    /// Side of a level's squares in pixels.
    #[inline(never)]
    pub fn side(&self, level: usize) -> usize {
        if level == 0 {
            1
        } else {
            self.least << (level - 1)
        }
    }

    /// How many of a level's squares lie along a side of one of the level above.
    #[inline(always)]
    pub fn parts(&self, level: usize) -> usize {
        if level == 0 { self.least } else { 2 }
    }

    /// Squares of a level side by side; the last ones may end beyond the picture.
    #[inline(never)]
    pub fn columns(&self, level: usize) -> usize {
        (self.right - self.left).div_ceil(self.side(level))
    }

    /// Squares of a level on top of each other.
    #[inline(never)]
    pub fn rows(&self, level: usize) -> usize {
        (self.bottom - self.top).div_ceil(self.side(level))
    }
}
