use crate::range_error::{Checked, Range, RangeError};
use crate::scene::ranges::SHARE;

/// An overlay of the traced points and the filled squares.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Method {
    /// The brightness of a white dot on every traced point, 0 to 1.
    pub points: f32,
    /// The brightness of the outlines of filled squares, 0 to 1.
    pub squares: f32,
    /// The brightness of the picture itself, 0 to 1.
    pub picture: f32,
    /// The side in pixels up to which squares are filled with one colour, whatever their corners
    /// show, 0 to 32; off below 2. A coarse picture is not antialiased.
    pub coarse: f32,
    /// The position of a bright line as a share of the picture's width from the left, 0 to 1. Left
    /// of it the picture is finished: at full brightness, antialiased, without marks.
    pub front: f32,
}

default!(Method = Self::PLAIN);

impl Method {
    /// No overlay.
    pub const PLAIN: Self =
        Self { points: 0.0, squares: 0.0, picture: 1.0, coarse: 0.0, front: 0.0 };

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        of.field("points", self.points, SHARE)?;
        of.field("squares", self.squares, SHARE)?;
        of.field("picture", self.picture, SHARE)?;
        of.field("coarse", self.coarse, Range(0.0, 32.0, "0 to 32"))?;
        of.field("front", self.front, SHARE)
    }
}
