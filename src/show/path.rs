//! Where the camera goes.

use crate::scene::Camera;
use crate::trigonometry::{cos, sin};
use glam::{Vec3A, vec3a};

/// A place of the camera, as seen from what it looks at.
#[derive(Clone, Copy)]
pub(super) struct Key {
    /// The middle of the picture.
    pub look_at: Vec3A,
    /// Radians about the y axis; at 0 it looks along z.
    pub angle: f32,
    /// Away from `look_at`, level.
    pub distance: f32,
    /// Above `look_at`.
    pub height: f32,
}

/// From one key, at `u` = 0, to another, at 1, evenly: about a circle, a spiral or along a line.
pub(super) fn between(a: &Key, b: &Key, u: f32) -> Camera {
    let mix = |a: f32, b: f32| a + (b - a) * u;
    let look_at = a.look_at + (b.look_at - a.look_at) * u;
    let angle = mix(a.angle, b.angle);
    let distance = mix(a.distance, b.distance);
    let height = mix(a.height, b.height);
    Camera {
        eye: look_at + vec3a(distance * sin(angle), height, -distance * cos(angle)),
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
