//! Where the camera goes.

use super::steps::{TENTHS, numbers, steps};
use crate::scene::{Camera, Method, Scene};
use crate::trigonometry::{cos, sin};
use glam::{Vec3A, vec3a};

/// A moment of a shot, in tenths: what the camera looks at, and where it stands from there: radians about the y axis, 0
/// along z; half its level distance; its height. Then how bright the method is shown: points, squares, picture.
pub(super) type Key = [i8; 9];

/// One without the method.
pub(super) const fn key(look_at: [f32; 3], angle: f32, distance: f32, height: f32) -> Key {
    let [x, y, z] = look_at;
    steps(
        [x, y, z, angle, 0.5 * distance, height, 0.0, 0.0, 1.0],
        TENTHS,
    )
}

/// One with it.
pub(super) const fn marked(key: Key, points: f32, squares: f32, picture: f32) -> Key {
    let [x, y, z, angle, half_distance, height, ..] = key;
    let [points, squares, picture] = steps([points, squares, picture], TENTHS);
    [
        x,
        y,
        z,
        angle,
        half_distance,
        height,
        points,
        squares,
        picture,
    ]
}

/// From one key, at `u` = 0, to another, at 1, evenly: about a circle, a spiral or along a line.
#[inline(never)]
pub(super) fn go([a, b]: &[Key; 2], u: f32, scene: &mut Scene) {
    let (mut way, to) = (numbers(a, TENTHS), numbers(b, TENTHS));
    for (number, to) in way.iter_mut().zip(to) {
        *number += (to - *number) * u;
    }
    let [
        x,
        y,
        z,
        angle,
        half_distance,
        height,
        points,
        squares,
        picture,
        ..,
    ] = way;
    scene.camera = orbit(vec3a(x, y, z), angle, 2.0 * half_distance, height);
    scene.method = Method {
        points,
        squares,
        picture,
    };
}

/// A camera that looks at a place from a distance, at an angle about it and from a height above it.
pub(super) fn orbit(look_at: Vec3A, angle: f32, distance: f32, height: f32) -> Camera {
    let away = vec3a(distance * sin(angle), height, -distance * cos(angle));
    Camera {
        eye: look_at + away,
        look_at,
        up: Vec3A::Y,
        field_of_view: core::f32::consts::FRAC_PI_4,
    }
}

/// From 0 at 0 to 1 at 1, level at both ends and beyond.
#[inline(never)]
pub(super) fn smooth(u: f32) -> f32 {
    let u = u.clamp(0.0, 1.0);
    u * u * (3.0 - 2.0 * u)
}
