//! What a sphere covers of the picture.

use crate::scene::camera::{Raster, pixels};
use glam::Vec3A;

/// A rectangle of the picture, in pixels; both ends included.
#[derive(Clone, Copy)]
pub(crate) struct Window {
    pub left: f32,
    pub right: f32,
    pub top: f32,
    pub bottom: f32,
}

/// Pixels around a bound, far more than its rounding.
const MARGIN: f32 = 0.5;

impl Window {
    /// No window, all zeros.
    pub const ZERO: Self = Self {
        left: 0.0,
        right: 0.0,
        top: 0.0,
        bottom: 0.0,
    };

    /// Nothing of the picture.
    const NONE: Self = Self {
        left: f32::INFINITY,
        right: f32::NEG_INFINITY,
        top: f32::INFINITY,
        bottom: f32::NEG_INFINITY,
    };

    /// All of the picture, and beyond.
    pub const ALL: Self = Self {
        left: f32::NEG_INFINITY,
        right: f32::INFINITY,
        top: f32::NEG_INFINITY,
        bottom: f32::INFINITY,
    };

    /// Where a sphere can be seen.
    #[inline(never)]
    pub fn of(
        centre: Vec3A,
        radius: f32,
        eye: Vec3A,
        raster: &Raster,
        width: usize,
        height: usize,
    ) -> Self {
        let to = centre - eye;
        let middle = |size: usize| 0.5 * (pixels(size) - 1.0);
        let Raster { corner, dx, dy } = *raster;
        let forward = corner + dx * middle(width) + dy * middle(height);
        let pixel = dx.length();
        let ahead = to.dot(forward);
        // A little larger than it is, so that what rounding adds is covered.
        let radius = radius * (1.0 + 1e-4);
        if ahead < -radius {
            return Self::NONE;
        }
        let (left, right) = slopes(to.dot(dx) / pixel, ahead, radius);
        let (top, bottom) = slopes(to.dot(dy) / pixel, ahead, radius);
        let window = Self {
            left: middle(width) + left / pixel - MARGIN,
            right: middle(width) + right / pixel + MARGIN,
            top: middle(height) + top / pixel - MARGIN,
            bottom: middle(height) + bottom / pixel + MARGIN,
        };
        // A scene with numbers that are none is looked at everywhere.
        let sum = (left + top) - (right + bottom);
        if sum.is_nan() { Self::ALL } else { window }
    }

    /// Whether it shares a point with the rectangle of these corners.
    #[inline(always)]
    pub fn meets(&self, [left, top, right, bottom]: [f32; 4]) -> bool {
        self.left <= right && self.right >= left && self.top <= bottom && self.bottom >= top
    }
}

/// The least and the greatest `x / z` of the points with z > 0 of a disc around (`x`, `z`): the slopes of its tangents
/// through the origin (Mara and McGuire: 2D Polyhedral Bounds of a Clipped, Perspective-Projected 3D Sphere, JCGT 2013).
#[inline(never)]
fn slopes(x: f32, z: f32, radius: f32) -> (f32, f32) {
    let tangent2 = x * x + z * z - radius * radius;
    if tangent2 <= 0.0 {
        return (f32::NEG_INFINITY, f32::INFINITY);
    }
    let t = libm::sqrtf(tangent2);
    let low = (x * t - z * radius, z * t + x * radius);
    let high = (x * t + z * radius, z * t - x * radius);
    // A tangent that points backwards leaves the picture on its side.
    (
        if low.1 > 0.0 {
            low.0 / low.1
        } else {
            f32::NEG_INFINITY
        },
        if high.1 > 0.0 {
            high.0 / high.1
        } else {
            f32::INFINITY
        },
    )
}
