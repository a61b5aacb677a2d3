use super::ranges::SHARE;
use crate::range_error::{Checked, RangeError};

/// The tone curve, vignette and dither of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Film {
    /// Whether light becomes colour by a filmic curve and a gamma of 2, so that bright things turn
    /// white: `c` becomes the root of `c (2.51 c + 0.03) / (c (2.43 c + 0.59) + 0.14)` (Narkowicz,
    /// "ACES filmic tone mapping curve", 2015). A ray then contributes 8 at most instead of 2. The
    /// scene's colours are linear: the square of a displayed colour is about right.
    pub filmic: bool,
    /// The darkening towards the corners, 0 to 1: the factor on light is `1 / (1 + vignette r^2)`
    /// at r half heights from the middle.
    pub vignette: f32,
    /// The range of the rounding thresholds of neighbouring pixels in steps of 1/255, 0 to 1. With
    /// 1, the means of squares of 4x4 pixels have steps of 1/16: slow gradients show no bands.
    /// Antialiased pixels keep their dither.
    pub dither: f32,
}

impl Film {
    /// No change, except clipping at 1.
    pub const PLAIN: Self = Self { filmic: false, vignette: 0.0, dither: 0.0 };

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        of.field("vignette", self.vignette, SHARE)?;
        of.field("dither", self.dither, SHARE)
    }
}
