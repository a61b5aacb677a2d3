//! Overlays of the picture: lines of text and copper bars.

use super::validate::{SHARE, SHARES};
use super::{List, MAX_LETTERS};
use glam::Vec3A;

fields! {
    /// A line of text, centred in the picture's width.
    pub struct Caption in "" {
        /// ASCII capitals and digits; any other byte is a space, but for the signs of digits, each of one number:
        ///
        /// | sign | in a scene | by [`Frame::write`](crate::Frame::write) |
        /// | --- | --- | --- |
        /// | `#` | the points that were traced for the frame | the first number |
        /// | `$` | the pixels of the frame | the second number |
        /// | `%` | a space | the third number |
        ///
        /// The last sign of a kind is the last digit of its number; a space stands where a number has no more digits.
        #[cfg_attr(feature = "serde", serde(with = "super::serial::text"))]
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

fields! {
    /// A bar across the whole picture that is shaded like a rod, as the Amiga's copper made them out of background colours.
    pub struct CopperBar in "" {
        /// The middle of the bar, as a share of the picture's height from the top, 0 to 1.
        middle: f32 = 0.5, in SHARE;
        /// Its height, 0 to 1, as a share of the picture's height.
        height: f32 = 0.05, in SHARE;
        /// The colour of its middle; towards its sides it is darker, and black on them.
        colour: Vec3A = Vec3A::ONE, in SHARES;
        /// How much of the picture it covers: from 0, invisible, to 1, all that is behind it.
        brightness: f32 = 1.0, in SHARE;
    }
}
