//! Where the camera goes.

use super::steps::{TENTHS, at, vector};
use crate::scene::Camera;
use crate::trigonometry::{cos, sin};
use glam::Vec3A;

/// A place of the camera, as seen from what it looks at.
pub(super) struct Key {
    /// The middle of the picture.
    look_at: [i8; 3],
    /// Radians about the y axis, 0 along z; scene units away from `look_at`, level, and above it. All in tenths, like
    /// places.
    way: [i8; 3],
}

impl Key {
    pub(super) const fn new(look_at: [f32; 3], angle: f32, distance: f32, height: f32) -> Self {
        let [x, y, z] = look_at;
        Self {
            look_at: at(x, y, z),
            // Halves, so that a byte holds them.
            way: at(angle, 0.5 * distance, height),
        }
    }
}

/// From one key, at `u` = 0, to another, at 1, evenly: about a circle, a spiral or along a line.
pub(super) fn between([a, b]: &[Key; 2], u: f32) -> Camera {
    let mix = |a: [i8; 3], b: [i8; 3]| {
        let (a, b) = (vector(a, TENTHS), vector(b, TENTHS));
        a + (b - a) * u
    };
    let [angle, half_distance, height] = mix(a.way, b.way).to_array();
    orbit(
        mix(a.look_at, b.look_at),
        angle,
        2.0 * half_distance,
        height,
    )
}

/// A camera that looks at a place from a distance, at an angle about it and from a height above it.
pub(super) fn orbit(look_at: Vec3A, angle: f32, distance: f32, height: f32) -> Camera {
    let away = Vec3A::new(distance * sin(angle), height, -distance * cos(angle));
    Camera {
        eye: look_at + away,
        look_at,
        up: Vec3A::Y,
        field_of_view: core::f32::consts::FRAC_PI_4,
    }
}

/// From 0 at 0 to 1 at 1, level at both ends and beyond.
pub(super) fn smooth(u: f32) -> f32 {
    let u = u.clamp(0.0, 1.0);
    u * u * (3.0 - 2.0 * u)
}
