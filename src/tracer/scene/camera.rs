use super::ranges::POINT;
use crate::maths::{cos, sin, to_f32};
use crate::range_error::{Checked, Range, RangeError};
use core::f32::consts::{FRAC_PI_4, PI};
use glam::{Vec3, Vec3A};

/// A pinhole camera with square pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Camera {
    /// The pinhole in scene units, coordinates -1e9 to 1e9.
    pub eye: Vec3,
    /// The point in the middle of the picture, in the same range, other than `eye`.
    pub look_at: Vec3,
    /// The upward direction of the picture, of any length, more than 0.001 radians off the line of
    /// sight.
    pub up: Vec3,
    /// The vertical field of view in radians, above 0 and below pi.
    pub field_of_view: f32,
    /// The least aspect (width divided by height) with this field of view, 0 to 4. Narrower
    /// pictures show the width of a picture of this aspect; with 0 they are cut off at the sides.
    pub min_aspect: f32,
}

default!(Camera = Self::STANDARD);

/// The picture plane at distance 1 from the eye: the ray through the pixel (x, y) has the direction
/// `corner + x dx + y dy`, not normalised.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Raster {
    /// The direction of the upper left pixel's centre.
    pub corner: Vec3,
    /// The step to the next column.
    pub dx: Vec3,
    /// The step to the next row.
    pub dy: Vec3,
}

impl Camera {
    pub(super) const STANDARD: Self = Self::new(Vec3::Z, Vec3::ZERO, FRAC_PI_4);

    /// Returns an upright camera, with a vertical field of view in radians.
    #[must_use]
    pub const fn new(eye: Vec3, look_at: Vec3, field_of_view: f32) -> Self {
        Self { eye, look_at, up: Vec3::Y, field_of_view, min_aspect: 0.0 }
    }

    fn forward(&self) -> Vec3 {
        (self.look_at - self.eye).normalize_or_zero()
    }

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        let forward = self.forward();
        let has_view = forward != Vec3::ZERO;
        // Nearer the line of sight, rounding decides where the picture's sides are.
        let is_upright = forward.cross(self.up.normalize_or_zero()).length() > 1e-3;
        let angle = Range(f32::from_bits(1), PI.next_down(), "above 0 and below pi");
        of.field("eye", self.eye, POINT)?;
        of.field("look_at", self.look_at, POINT)?;
        of.rule("look_at", self.look_at, has_view, "different from eye")?;
        let sides = "more than 0.001 radians off the line of sight";
        of.rule("up", self.up, is_upright, sides)?;
        of.field("field_of_view", self.field_of_view, angle)?;
        of.field("min_aspect", self.min_aspect, Range(0.0, 4.0, "0 to 4"))
    }

    /// Returns the side of a pixel at distance 1 from the eye, in a picture of `width` by `height`
    /// pixels.
    #[inline]
    #[must_use]
    pub fn pixel(&self, width: usize, height: usize) -> f32 {
        let half_angle = self.field_of_view * 0.5;
        let pixel = 2.0 * sin(half_angle) / cos(half_angle) / to_f32(height);
        pixel * self.widening(width, height)
    }

    /// Returns the factor by which a picture narrower than `min_aspect` shows more.
    #[inline]
    pub(crate) fn widening(&self, width: usize, height: usize) -> f32 {
        (self.min_aspect * to_f32(height) / to_f32(width)).max(1.0)
    }

    /// Returns the rays through a picture of `width` by `height` pixels.
    #[must_use]
    // Saves 29 packed bytes.
    #[inline(never)]
    pub fn raster(&self, width: usize, height: usize) -> Raster {
        let forward = unit(Vec3A::from(self.look_at) - Vec3A::from(self.eye), Vec3A::NEG_Z);
        let right =
            unit(forward.cross(self.up.into()), unit(forward.any_orthogonal_vector(), Vec3A::X));
        let up = right.cross(forward);
        let pixel = self.pixel(width, height);
        let (dx, dy) = (right * pixel, up * -pixel);
        let half = |side: usize| 0.5 - 0.5 * to_f32(side);
        Raster {
            corner: (forward + dx * half(width) + dy * half(height)).into(),
            dx: dx.into(),
            dy: dy.into(),
        }
    }
}

/// Returns `otherwise` if `v` is zero, infinite or NaN.
fn unit(v: Vec3A, otherwise: Vec3A) -> Vec3A {
    let length = v.length();
    if length > 0.0 && length < f32::INFINITY { v * (1.0 / length) } else { otherwise }
}
