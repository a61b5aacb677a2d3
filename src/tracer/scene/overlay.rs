//! Overlays of the picture: lines of text and copper bars.

use super::validate::SHARE;
use super::{List, MAX_LETTERS};
use crate::range_error::{Checked, RangeError};
use glam::Vec3;

/// A line of text, centred in the picture's width.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Caption {
    /// ASCII capitals, digits, full stops, and `/` for ±. Any other byte is a space, except the signs of digits, each of one number:
    ///
    /// | sign | in a scene | by [`Frame::write`](crate::Frame::write) |
    /// | --- | --- | --- |
    /// | `#` | the points that were traced for the frame | the first number |
    /// | `$` | the pixels of the frame | the second number |
    /// | `%` | a space | the third number |
    /// | `&` | a space | the fourth number |
    ///
    /// The last sign of a kind is the last digit of its number; a space stands where a number has no more digits.
    #[cfg_attr(feature = "serde", serde(with = "super::serial::text"))]
    pub letters: List<u8, MAX_LETTERS>,
    /// The middle of the line, as a share of the picture's height from the top, 0 to 1.
    pub middle: f32,
    /// The height of a letter, 0 to 1, as a share of the picture's height. In a picture narrower than 16:9 it is a share of the
    /// height that a 16:9 picture of the same width has, so that lines are not cut off.
    pub size: f32,
    /// From 0, invisible, to 1, white.
    pub brightness: f32,
}

impl Default for Caption {
    fn default() -> Self {
        Self {
            letters: List::default(),
            middle: 0.9,
            size: 0.05,
            brightness: 1.0,
        }
    }
}

impl Caption {
    pub(super) const ZERO: Self = Self {
        letters: List::over(0),
        middle: 0.0,
        size: 0.0,
        brightness: 0.0,
    };

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        of.field("middle", self.middle, SHARE)?;
        of.field("size", self.size, SHARE)?;
        of.field("brightness", self.brightness, SHARE)
    }
}

/// A bar across the whole picture that is shaded like a rod, as the Amiga's copper made them out of background colours.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct CopperBar {
    /// The middle of the bar, as a share of the picture's height from the top, 0 to 1.
    pub middle: f32,
    /// Its height, 0 to 1, as a share of the picture's height.
    pub height: f32,
    /// The colour of its middle, 0 to 1 in each channel; towards its sides it is darker, and black on them.
    pub colour: Vec3,
    /// How much of the picture it covers: from 0, invisible, to 1, all that is behind it.
    pub brightness: f32,
}

impl Default for CopperBar {
    fn default() -> Self {
        Self {
            middle: 0.5,
            height: 0.05,
            colour: Vec3::ONE,
            brightness: 1.0,
        }
    }
}

impl CopperBar {
    pub(super) const ZERO: Self = Self {
        middle: 0.0,
        height: 0.0,
        colour: Vec3::ZERO,
        brightness: 0.0,
    };

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        of.field("middle", self.middle, SHARE)?;
        of.field("height", self.height, SHARE)?;
        of.field("colour", self.colour, SHARE)?;
        of.field("brightness", self.brightness, SHARE)
    }
}
