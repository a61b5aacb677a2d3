//! Waves on water.

use super::validate::EXTENT;
use crate::range_error::{Checked, Range, RangeError};

/// Waves on the first plane of a scene, which make water of a mirror. They tilt the normals by which light is reflected, and leave
/// the plane where it is.
///
/// There are six, each [`Waves::SHORTER`] times as long as the one before, and of the same slope. The first goes along z, the others
/// in directions that are each turned by [`Waves::TURN`] radians more from z towards x. At a point u wavelengths from where a wave
/// is level, -1/2 to 1/2, it rises by `8 u (1 - 2 |u|)` times the slope: two arcs of parabolas, nearly a sine.
///
/// Where a pixel sees w scene units along the water, a wave of the length l has the share `1 - w x / l` of its slope, where x is
/// [`Waves::PIXELS`], and none if that is negative: what is too fine to be drawn, far from the eye, is calm.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Waves {
    /// The steepest slope of each wave, 0 to 0.1. With 0 there are none.
    pub slope: f32,
    /// The length of the longest wave in scene units, [`MIN_LENGTH`](super::MIN_LENGTH) to [`MAX_LENGTH`](super::MAX_LENGTH); or 0 if
    /// `slope` is.
    pub length: f32,
    /// How far they have gone on, in lengths of the longest wave, -1e6 to 1e6. Each wave goes on by [`Waves::FASTER`] times as many
    /// of its own lengths as the one before, as waves of deep water do.
    pub phase: f32,
}

impl Waves {
    /// The longest wave is less than so many times as long as any: there are six.
    pub const FINEST: f32 = 20.0;
    /// A wave's length, as a share of that of the one before.
    pub const SHORTER: f32 = 0.5625;
    /// How many more of its lengths a wave goes on than the one before: the root of 1 / [`Waves::SHORTER`].
    pub const FASTER: f32 = 4.0 / 3.0;
    /// The angle between the directions of a wave and of the next, in radians: the golden angle, so that none are alike.
    pub const TURN: f32 = 2.4;
    /// The length, in pixels, at which waves end: the corners of squares of 8 pixels would meet such waves at random.
    pub const PIXELS: f32 = 10.0;

    /// The steepest slope of all waves together, as a share of the steepness of the ray that sees them, which is by how much it goes
    /// down in each unit of its length. Steeper water is that steep: it does not turn its back to the ray, nor mirror it to below
    /// the water.
    pub const STEEPEST: f32 = 0.375;

    /// No waves: a flat mirror.
    pub const CALM: Self = Self {
        slope: 0.0,
        length: 0.0,
        phase: 0.0,
    };

    /// Whether there are none.
    pub(crate) fn are_calm(&self) -> bool {
        self.slope == 0.0
    }

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        let has_length = EXTENT.holds(self.length) || self.are_calm() && self.length == 0.0;
        of.field("slope", self.slope, Range(0.0, 0.1, "0 to 0.1"))?;
        of.rule("length", self.length, has_length, EXTENT.2)?;
        of.field("phase", self.phase, Range(-1e6, 1e6, "-1e6 to 1e6"))
    }
}
