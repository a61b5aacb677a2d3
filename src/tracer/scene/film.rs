//! How light becomes the picture's colours.

use super::validate::SHARE;

fields! {
    /// The treatment of the light that reaches the picture, before it is cut to 0 to 1.
    pub struct Film in "" {
        /// Where highlights begin to roll off, 0 to 1: a channel `c` above this shoulder `s` becomes `s + x (1 - s) / (1 - s + x)`,
        /// where x is `c - s`, so that it goes on smoothly and never reaches 1. What one ray brings is cut at 2 before. With 1
        /// highlights are cut at 1, and nothing below changes.
        shoulder: f32 = 1.0, in SHARE;
        /// How much darker the picture is towards its corners, 0 to 1: light is multiplied by `1 / (1 + vignette r^2)`, at the distance
        /// r from the picture's middle in halves of its height. 0 leaves it as it is.
        vignette: f32 = 0.0, in SHARE;
        /// How far the thresholds are apart at which neighbouring pixels are rounded up to the next of the 255 steps of the output, 0
        /// to 1 step. With 1 a mean over squares of 4x4 pixels has steps of 1/16, so that slow gradients show no bands; with 0 all
        /// pixels are rounded alike. The threshold of a pixel depends on its place alone; pixels on edges, which are antialiased, keep
        /// that of the picture before.
        dither: f32 = 0.0, in SHARE;
        /// The share of a [`Quality`](crate::Quality)'s tolerances within which squares are filled, 0 to 1. In the dark the eye sees steps that it
        /// does not see in a bright picture; less than 1 is for scenes with dim edges that matter.
        tolerance: f32 = 1.0, in SHARE;
    }
}

impl Film {
    /// Light as it is, cut at 1.
    pub const PLAIN: Self = Self::STANDARD;
}
