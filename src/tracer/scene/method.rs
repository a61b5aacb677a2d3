//! Explanation of the rendering method: an overlay, and a picture that has not been refined to its end.

use super::validate::SHARE;
use crate::range_error::{Checked, Range, RangeError};

/// How brightly a frame shows the points that were traced, the squares that were filled, and the picture itself, 0 to 1 each;
/// and how coarse the picture stays.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Method {
    /// Brightness of a white dot on every point that was traced.
    pub points: f32,
    /// Brightness of the outlines of the squares that were filled.
    pub squares: f32,
    /// Brightness of the picture itself; 1 leaves it as it is.
    pub picture: f32,
    /// The side in pixels up to which squares are filled with one colour, whatever their corners show: 0 to
    /// [`Quality::MAX_SQUARE`](crate::Quality::MAX_SQUARE); below 2 there are none. The largest squares are as large as these, and a
    /// coarse picture is not antialiased.
    pub coarse: f32,
    /// How far a front has come over the picture from the left, as a share of its width, 0 to 1. Behind it the picture is finished:
    /// at full brightness and antialiased, without marks. The front itself is a bright line.
    pub front: f32,
}

impl Default for Method {
    fn default() -> Self {
        Self::PLAIN
    }
}

impl Method {
    /// The picture without an overlay.
    pub const PLAIN: Self = Self {
        points: 0.0,
        squares: 0.0,
        picture: 1.0,
        coarse: 0.0,
        front: 0.0,
    };

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        of.field("points", self.points, SHARE)?;
        of.field("squares", self.squares, SHARE)?;
        of.field("picture", self.picture, SHARE)?;
        of.field("coarse", self.coarse, Range(0.0, 32.0, "0 to 32"))?;
        of.field("front", self.front, SHARE)
    }
}
