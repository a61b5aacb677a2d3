//! How light becomes the picture's colours.

use super::validate::SHARE;
use crate::range_error::{Checked, RangeError};

/// The treatment of the light that reaches the picture, before it is cut to 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Film {
    /// Where highlights begin to roll off, 0 to 1: a channel `c` above this shoulder `s` becomes `s + x (1 - s) / (1 - s + x)`,
    /// where x is `c - s`, so that it goes on smoothly and never reaches 1. What one ray brings is cut at 2 before. With 1
    /// highlights are cut at 1, and nothing below changes.
    pub shoulder: f32,
    /// How much darker the picture is towards its corners, 0 to 1: light is multiplied by `1 / (1 + vignette r^2)`, at the distance
    /// r from the picture's middle in halves of its height. 0 leaves it as it is.
    pub vignette: f32,
    /// How far the thresholds are apart at which neighbouring pixels are rounded up to the next of the 255 steps of the output, 0
    /// to 1 step. With 1 a mean over squares of 4x4 pixels has steps of 1/16, so that slow gradients show no bands; with 0 all
    /// pixels are rounded alike. The threshold of a pixel depends on its place alone; pixels on edges, which are antialiased, keep
    /// that of the picture before.
    pub dither: f32,
    /// The share of a [`Quality`](crate::Quality)'s tolerances within which squares are filled, 0 to 1. In the dark the eye sees steps that it
    /// does not see in a bright picture; less than 1 is for scenes with dim edges that matter.
    pub tolerance: f32,
}

impl Default for Film {
    fn default() -> Self {
        Self::PLAIN
    }
}

impl Film {
    /// Light as it is, cut at 1.
    pub const PLAIN: Self = Self {
        shoulder: 1.0,
        vignette: 0.0,
        dither: 0.0,
        tolerance: 1.0,
    };

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        of.field("shoulder", self.shoulder, SHARE)?;
        of.field("vignette", self.vignette, SHARE)?;
        of.field("dither", self.dither, SHARE)?;
        of.field("tolerance", self.tolerance, SHARE)
    }
}
