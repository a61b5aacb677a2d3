//! The pinhole camera.

use crate::maths::{cos, sin};
use glam::Vec3A;

/// A pinhole camera with square pixels; a pixel's sample is its centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Where it stands.
    pub eye: Vec3A,
    /// The point in the middle of the picture; not the eye.
    pub look_at: Vec3A,
    /// The direction that is up in the picture; not along the line of sight.
    pub up: Vec3A,
    /// Vertical field of view in radians, above 0 and below pi.
    pub field_of_view: f32,
}

impl Default for Camera {
    fn default() -> Self {
        Self {
            eye: Vec3A::Z,
            look_at: Vec3A::ZERO,
            up: Vec3A::Y,
            field_of_view: core::f32::consts::FRAC_PI_4,
        }
    }
}

/// The picture plane of a camera: pixel (x, y) looks along `corner + x dx + y dy`, not normalised.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Raster {
    /// Through the centre of the upper left pixel.
    pub corner: Vec3A,
    /// One pixel to the right.
    pub dx: Vec3A,
    /// One pixel down.
    pub dy: Vec3A,
}

impl Raster {
    /// No picture.
    pub const NONE: Self = Self {
        corner: Vec3A::ZERO,
        dx: Vec3A::ZERO,
        dy: Vec3A::ZERO,
    };
}

impl Camera {
    /// The picture plane for a picture of `width` by `height` pixels, at distance 1 from the eye.
    #[must_use]
    pub fn raster(&self, width: usize, height: usize) -> Raster {
        let forward = unit(self.look_at - self.eye, Vec3A::NEG_Z);
        let right = unit(forward.cross(self.up), forward.any_orthonormal_vector());
        let up = right.cross(forward);
        let half_angle = self.field_of_view * 0.5;
        let pixel = 2.0 * sin(half_angle) / cos(half_angle) / pixels(height);
        let (dx, dy) = (right * pixel, up * -pixel);
        let half = |side: usize| 0.5 - 0.5 * pixels(side);
        Raster {
            corner: forward + dx * half(width) + dy * half(height),
            dx,
            dy,
        }
    }
}

/// A vector of length 1 along another, or something else where that has no direction.
fn unit(v: Vec3A, otherwise: Vec3A) -> Vec3A {
    let length = v.length();
    // Both less than nothing and not a number.
    if length > 0.0 && length < f32::INFINITY {
        v * (1.0 / length)
    } else {
        otherwise
    }
}

/// A number of pixels, below 2^24. By way of `i32`, which one instruction converts.
#[inline(always)]
pub(crate) fn pixels(number: usize) -> f32 {
    number as i32 as f32
}
