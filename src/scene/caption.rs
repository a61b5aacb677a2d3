//! A line of text over the picture.

use super::List;

/// The most letters in a caption. The longest in the show has 32.
pub const MAX_LETTERS: usize = 32;

/// A line of text, centred in the picture's width.
#[derive(Clone, Copy, Debug, Default)]
pub struct Caption {
    /// ASCII capitals and digits. Each `#` stands for a digit of the number of points that were traced for the frame, before edges
    /// got their samples, and each `$` for one of the number of its pixels, the last one of a caption for the last digit. Any other
    /// byte is a space.
    pub letters: List<u8, MAX_LETTERS>,
    /// The middle of the line, as a share of the picture's height from the top, 0 to 1.
    pub middle: f32,
    /// The height of a letter, 0 to 1, as a share of the picture's height. In a picture narrower than 16:9 it is a share of the
    /// height that a 16:9 picture of the same width has, so that lines are not cut off.
    pub size: f32,
    /// From 0, invisible, to 1, white.
    pub brightness: f32,
}

impl Caption {
    /// All zeros: an empty line.
    pub(crate) const ZERO: Self = Self {
        letters: List::over(0),
        middle: 0.0,
        size: 0.0,
        brightness: 0.0,
    };
}
