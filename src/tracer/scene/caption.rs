//! A line of text over the picture.

use super::validate::SHARE;
use super::{List, MAX_LETTERS};

fields! {
    /// A line of text, centred in the picture's width.
    pub struct Caption in "" {
        /// ASCII capitals and digits. Each `#` stands for a digit of the number of points that were traced for the frame, before edges
        /// got their samples, and each `$` for one of the number of its pixels, the last one of a caption for the last digit. Any other
        /// byte is a space.
        letters: List<u8, MAX_LETTERS> = List::over(0);
        /// The middle of the line, as a share of the picture's height from the top, 0 to 1.
        middle: f32 = 0.9, in SHARE;
        /// The height of a letter, 0 to 1, as a share of the picture's height. In a picture narrower than 16:9 it is a share of the
        /// height that a 16:9 picture of the same width has, so that lines are not cut off.
        size: f32 = 0.05, in SHARE;
        /// From 0, invisible, to 1, white.
        brightness: f32 = 1.0, in SHARE;
    }
}
