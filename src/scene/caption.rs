//! A line of text over the picture.

use super::List;

/// Letters a caption can hold: the longest line in use has 28.
pub const MAX_LETTERS: usize = 32;

/// A line of text, in the middle of the picture's width.
#[derive(Clone, Copy, Debug, Default)]
pub struct Caption {
    /// Capitals and digits in ASCII; anything else is a space.
    pub letters: List<u8, MAX_LETTERS>,
    /// How far down the middle of the line is, as a share of the picture's height.
    pub middle: f32,
    /// Height of a letter, as a share of the picture's height; of a picture narrower than 16:9, of the height that it would
    /// have with that.
    pub size: f32,
    /// 0 is not seen, 1 is white.
    pub brightness: f32,
}

impl Caption {
    /// Nothing, all zeros.
    pub(crate) const NONE: Self = Self {
        letters: List::over(0),
        middle: 0.0,
        size: 0.0,
        brightness: 0.0,
    };
}
