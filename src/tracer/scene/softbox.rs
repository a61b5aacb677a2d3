use super::ranges::{LENGTH, POINT};
use crate::range_error::{Checked, Range, RangeError};
use glam::Vec3;

/// A rectangle of light at infinity. Reflected and transmitted rays that leave the scene see it;
/// camera rays do not, and it lights no surface.
///
/// Its sides are level and upright. A direction `d` with the components x and y along the sides and
/// z towards the middle has the share `s^2 (3 - 2 s)` of the colour, with
/// `s = min(half_width - |x / z|, half_height - |y / z|) / softness`, 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Softbox {
    /// The direction of the middle, of any length above 0.
    pub aim: Vec3,
    /// Half the width at distance 1, 0.001 to 1000.
    pub half_width: f32,
    /// Half the height at distance 1, 0.001 to 1000.
    pub half_height: f32,
    /// The width of the soft edge inside the sides, at distance 1, 0.001 to 1000. Squares may lose
    /// edges of a few pixels.
    pub softness: f32,
    /// The colour, 0 to 1e9 in each channel.
    pub colour: Vec3,
}

zero! { Softbox { aim, half_width, half_height, softness, colour } }

impl Softbox {
    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        let size = Range(1e-3, 1e3, "0.001 to 1000");
        let is_aimed = self.aim.normalize_or_zero() != Vec3::ZERO;
        of.field("aim", self.aim, POINT)?;
        of.rule("aim", self.aim, is_aimed, "longer than 0")?;
        of.field("half_width", self.half_width, size)?;
        of.field("half_height", self.half_height, size)?;
        of.field("softness", self.softness, size)?;
        of.field("colour", self.colour, LENGTH)
    }
}
