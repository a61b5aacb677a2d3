//! Captions over the picture.

use crate::range_error::{Checked, RangeError};
use crate::scene::List;
use crate::scene::ranges::SHARE;

/// The maximum number of letters in a caption. The longest of the show has 32.
pub const MAX_LETTERS: usize = 32;

/// A line of text, centred in the picture's width.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Caption {
    /// ASCII capitals, digits, full stops, and `/` for ±. Other bytes are spaces. These signs are
    /// digits of a number:
    ///
    /// | sign | in a scene | in [`Frame::write`](crate::Frame::write) |
    /// | --- | --- | --- |
    /// | `#` | the traced points of the frame | the first number |
    /// | `$` | the pixels of the frame | the second number |
    /// | `%` | a space | the third number |
    /// | `&` | a space | the fourth number |
    ///
    /// The last sign of a kind is the last digit; leading zeros are spaces.
    #[cfg_attr(feature = "serde", serde(with = "crate::scene::serial::text"))]
    pub letters: List<u8, MAX_LETTERS>,
    /// The middle of the line, relative to the picture's height from the top, 0 to 1.
    pub middle: f32,
    /// The height of a letter relative to the picture's height, 0 to 1. Pictures narrower than 16:9
    /// count as 16:9 pictures of the same width, so that lines fit.
    pub size: f32,
    /// The opacity of the white letters, 0 to 1.
    pub brightness: f32,
}

default!(Caption = Self { letters: List::default(), middle: 0.9, size: 0.05, brightness: 1.0 });

zero! { Caption { letters, middle, size, brightness } }

impl Caption {
    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        of.field("middle", self.middle, SHARE)?;
        of.field("size", self.size, SHARE)?;
        of.field("brightness", self.brightness, SHARE)
    }
}
