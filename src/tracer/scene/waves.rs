//! Waves on water.

use super::ranges::EXTENT;
use crate::range_error::{Checked, Range, RangeError};

/// Waves on the first plane of a scene, which turn a mirror into water. They tilt normals; the
/// plane stays flat.
///
/// Each of six waves of equal slope is [`Waves::SHORTER`] times as long as the previous one. The
/// first travels along z, each next one is turned by [`Waves::TURN`] from z towards x. At u
/// wavelengths from a level point, -1/2 to 1/2, the slope is `8 u (1 - 2 |u|)` times the steepest
/// one, nearly a sine.
///
/// Where a pixel covers w scene units, the slope of a wave of the length l is multiplied by
/// `1 - w x / l`, at least 0, where x is
/// [`Waves::PIXELS`]: distant water is calm.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Waves {
    /// The steepest slope of each wave, 0 to 0.1. 0 turns waves off.
    pub slope: f32,
    /// The length of the longest wave in scene units, 1e-9 to 1e9, or 0 if `slope` is 0.
    pub length: f32,
    /// The distance travelled by the longest wave in its lengths, -1e6 to 1e6. Each next wave
    /// travels [`Waves::FASTER`] times as far in its own lengths, as on deep water.
    pub phase: f32,
}

impl Waves {
    /// An upper bound of the longest wave's length, relative to the shortest's.
    pub const FINEST: f32 = 20.0;
    /// The ratio of the lengths of a wave and the previous one.
    pub const SHORTER: f32 = 0.5625;
    /// The root of 1 / [`Waves::SHORTER`].
    pub const FASTER: f32 = 4.0 / 3.0;
    /// The golden angle in radians, so that all directions differ.
    pub const TURN: f32 = 2.4;
    /// The length in pixels below which waves vanish: the corners of 8-pixel squares would sample
    /// them at random.
    pub const PIXELS: f32 = 10.0;

    /// The limit of the total slope, relative to a ray's descent per unit of length: the water
    /// never faces away from the ray, nor reflects it below the surface.
    pub const STEEPEST: f32 = 0.375;

    /// A flat mirror.
    pub const CALM: Self = Self { slope: 0.0, length: 0.0, phase: 0.0 };

    pub(crate) fn is_calm(&self) -> bool {
        self.slope == 0.0
    }

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        let has_length = EXTENT.contains(self.length) || self.is_calm() && self.length == 0.0;
        of.field("slope", self.slope, Range(0.0, 0.1, "0 to 0.1"))?;
        of.rule("length", self.length, has_length, EXTENT.2)?;
        of.field("phase", self.phase, Range(-1e6, 1e6, "-1e6 to 1e6"))
    }
}
