//! Procedural textures: stripes, checkers, marble and swirling bands.

use super::ranges::{SHARE, SIGNED, THOUSAND};
use crate::range_error::{Checked, RangeError};
use crate::zero::Zero;
use glam::Vec3;

/// A procedural texture of two colours: the surface's, and a darker one.
///
/// Coordinates are relative to the object's centre, along a block's axes, or along the scene's axes
/// for spheres and planes. Along each axis runs a triangle wave between -1 and 1 with a maximum at
/// 0. The smallest of the waves' magnitudes, with the sign of their product, is multiplied by
/// `edge`, shifted by `balance` and clamped to -1 to 1. Waves along one axis give stripes, along
/// two or three checkers half a period wide. Noise along x turns stripes into marble.
///
/// Swirls turn stripes into the bands of a giant planet. They shear the coordinates seven times
/// along each axis, each time by finer waves: x by waves along y, y by waves along z, z by waves
/// along x. Waves below four pixels vanish.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Pattern {
    /// Periods per scene unit along x, y and z, 0 to 1000.
    pub waves: Vec3,
    /// The share of the colour that the darkest points lose, 0 to 1.
    pub depth: f32,
    /// The steepness of transitions, 0 to 1000: 1 is the triangle wave itself. Against aliasing,
    /// transitions are at least one pixel wide, and waves shorter than a pixel average out.
    pub edge: f32,
    /// The balance of light and dark, -1 to 1: `balance * max(edge, 1)` is added to the pattern.
    /// With sharp edges, light stripes take the share `(1 + balance) / 2`, which is the mean far
    /// from the eye. Near 1 thin dark veins are left.
    pub balance: f32,
    /// The amplitude in periods of the noise that shifts the pattern along x, 0 to 1000. Octaves of
    /// half the size and amplitude are added while their amplitude is above [`Pattern::MIN_WARP`].
    pub warp: f32,
    /// Cells of the coarsest octave of noise and swirls per scene unit, 0 to 1000.
    pub grain: f32,
    /// The strength of swirls, 0 to 1: the amplitude of each octave's waves, relative to their
    /// length.
    pub swirl: f32,
    /// The stretch of swirling patterns along x and z, 0 to 1: these coordinates are multiplied by
    /// `1 - stretch`.
    pub stretch: f32,
    /// The darker colour relative to the surface's, 0 to 1 in each channel, for a `depth` of 1.
    pub tint: Vec3,
}

zero! { Pattern { waves, depth, edge, balance, warp, grain, swirl, stretch, tint } }

impl Pattern {
    /// Returns checkers of `side` scene units, for horizontal planes.
    #[must_use]
    pub const fn checkers(side: f32, depth: f32) -> Self {
        Self { waves: Vec3::new(0.5 / side, 0.0, 0.5 / side), depth, edge: 30.0, ..Self::NONE }
    }

    /// The largest amplitude of noise octaves that are left out: a fifth of a period is hardly
    /// visible.
    pub const MIN_WARP: f32 = 0.2;

    /// A uniform colour.
    pub const NONE: Self = Self::ZERO;

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        of.field("material.pattern.waves", self.waves, THOUSAND)?;
        of.field("material.pattern.depth", self.depth, SHARE)?;
        of.field("material.pattern.edge", self.edge, THOUSAND)?;
        of.field("material.pattern.balance", self.balance, SIGNED)?;
        of.field("material.pattern.warp", self.warp, THOUSAND)?;
        of.field("material.pattern.grain", self.grain, THOUSAND)?;
        of.field("material.pattern.swirl", self.swirl, SHARE)?;
        of.field("material.pattern.stretch", self.stretch, SHARE)?;
        of.field("material.pattern.tint", self.tint, SHARE)
    }
}
