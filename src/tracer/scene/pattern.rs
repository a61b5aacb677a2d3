//! Procedural textures: stripes, checkers and marble.

use super::validate::{SHARE, SIGNED, THOUSAND};
use crate::range_error::{Checked, RangeError};
use glam::Vec3;

/// A procedural texture that darkens the colour of a surface.
///
/// It is a function of the point's coordinates in scene units, measured from the object's centre along the object's own axes;
/// those of spheres and planes are the scene's. Along each axis runs a triangle wave between -1 and 1, with `waves` periods per
/// unit and a maximum at 0. The pattern has the smallest of the three magnitudes and the sign of the three waves' product; it
/// is multiplied by `edge`, shifted by `balance` and clamped to -1 to 1. Waves along one axis give stripes, waves along two or
/// three give checkers, with fields half a period wide. Noise that shifts the pattern along x turns stripes into marble.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Pattern {
    /// Periods per scene unit along x, y and z, 0 to 1000. The pattern does not change along an axis with 0.
    pub waves: Vec3,
    /// The share of the colour that the darkest points lose, 0 to 1. With 0 there is no pattern.
    pub depth: f32,
    /// The steepness of the transitions between light and dark, up to 1000: 1 is the triangle wave itself, larger values make
    /// sharper edges. Far from the eye the transitions are widened to at least one pixel, and waves shorter than a pixel average
    /// out, so that the pattern does not alias.
    pub edge: f32,
    /// How much of the surface is light and how much dark, -1 to 1: `balance * max(edge, 1)` is added to the pattern. Where edges
    /// are sharp, stripes are light over the share `(1 + balance) / 2`. 0 is half and half, near 1 leaves thin veins in a light
    /// ground; far from the eye both average out to that mean.
    pub balance: f32,
    /// The amplitude of the noise that shifts the pattern along x, in periods, 0 to 1000. Octaves of half the size and half the
    /// amplitude follow as long as their amplitude is above [`Pattern::LEAST_WARP`].
    pub warp: f32,
    /// Cells of the noise's coarsest octave per scene unit, 0 to 1000.
    pub grain: f32,
}

impl Pattern {
    /// Checkers on a horizontal plane, whose dark fields lose the share `depth` of the colour, 0 to 1. Fields are `side` wide, in
    /// scene units.
    #[must_use]
    pub const fn checkers(side: f32, depth: f32) -> Self {
        Self {
            waves: Vec3::new(0.5 / side, 0.0, 0.5 / side),
            depth,
            edge: 30.0,
            ..Self::NONE
        }
    }

    /// Octaves of noise with this amplitude or less are left out: a fifth of a period is hardly visible.
    pub const LEAST_WARP: f32 = 0.2;

    /// No pattern: the colour is uniform.
    pub const NONE: Self = Self {
        waves: Vec3::ZERO,
        depth: 0.0,
        edge: 0.0,
        balance: 0.0,
        warp: 0.0,
        grain: 0.0,
    };

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        of.field("material.pattern.waves", self.waves, THOUSAND)?;
        of.field("material.pattern.depth", self.depth, SHARE)?;
        of.field("material.pattern.edge", self.edge, THOUSAND)?;
        of.field("material.pattern.balance", self.balance, SIGNED)?;
        of.field("material.pattern.warp", self.warp, THOUSAND)?;
        of.field("material.pattern.grain", self.grain, THOUSAND)
    }
}
