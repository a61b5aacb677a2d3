//! The pinhole camera.

use crate::trigonometry::{cos, sin};
use glam::Vec3A as Vec3;

/// A pinhole camera with square pixels; a pixel's sample is its centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Where it stands.
    pub eye: Vec3,
    /// The point in the middle of the picture; not the eye.
    pub look_at: Vec3,
    /// The direction that is up in the picture; not along the line of sight.
    pub up: Vec3,
    /// Vertical field of view in radians, above 0 and below pi.
    pub field_of_view: f32,
}

impl Default for Camera {
    fn default() -> Self {
        Self {
            eye: Vec3::Z,
            look_at: Vec3::ZERO,
            up: Vec3::Y,
            field_of_view: core::f32::consts::FRAC_PI_4,
        }
    }
}

/// The picture plane of a camera: pixel (x, y) looks along `corner + x dx + y dy`, not normalised.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Raster {
    /// Through the centre of the upper left pixel.
    pub corner: Vec3,
    /// One pixel to the right.
    pub dx: Vec3,
    /// One pixel down.
    pub dy: Vec3,
}

impl Raster {
    /// No picture.
    pub const NONE: Self = Self {
        corner: Vec3::ZERO,
        dx: Vec3::ZERO,
        dy: Vec3::ZERO,
    };
}

impl Camera {
    /// The picture plane for a picture of `width` by `height` pixels, at distance 1 from the eye.
    #[must_use]
    pub fn raster(&self, width: usize, height: usize) -> Raster {
        let forward = unit(self.look_at - self.eye, Vec3::NEG_Z);
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
#[inline(never)]
fn unit(v: Vec3, otherwise: Vec3) -> Vec3 {
    let length = v.length();
    // Both less than nothing and not a number.
    if length > 0.0 && length < f32::INFINITY {
        v * (1.0 / length)
    } else {
        otherwise
    }
}

/// A number of pixels. It takes the way of `i32`, which the processor knows; from `usize` it takes 30 bytes more.
#[inline(always)]
pub(crate) fn pixels(number: usize) -> f32 {
    number as i32 as f32
}
