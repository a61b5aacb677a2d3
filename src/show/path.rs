//! Where the camera goes.

use crate::maths::{cos, sin};
use crate::scene::{Camera, Method, Scene};
use glam::{Vec3A, vec3a};

/// A moment of a shot: what the camera looks at, and where it stands from there.
#[derive(Clone, Copy)]
pub(super) struct Keyframe {
    /// In scene units.
    look_at: Vec3A,
    /// Radians about the y axis; at 0 the camera looks along z.
    angle: f32,
    /// The level distance from what it looks at, in scene units.
    distance: f32,
    /// The height above what it looks at, in scene units.
    height: f32,
    /// How the picture shows its own making.
    method: Method,
}

/// A keyframe of the plain picture.
pub(super) const fn key(look_at: [f32; 3], angle: f32, distance: f32, height: f32) -> Keyframe {
    Keyframe {
        look_at: Vec3A::from_array(look_at),
        angle,
        distance,
        height,
        method: Method::PLAIN,
    }
}

impl Keyframe {
    /// The same, with points, squares and picture so bright, 0 to 1 each.
    pub const fn marked(self, points: f32, squares: f32, picture: f32) -> Self {
        Self {
            method: Method {
                points,
                squares,
                picture,
            },
            ..self
        }
    }
}

/// From one keyframe, at `u` = 0, to another, at 1, evenly: about a circle, a spiral or along a line.
pub(super) fn go([from, to]: &[Keyframe; 2], u: f32, scene: &mut Scene) {
    let between = |from: f32, to: f32| from + (to - from) * u;
    scene.camera = orbit(
        from.look_at + (to.look_at - from.look_at) * u,
        between(from.angle, to.angle),
        between(from.distance, to.distance),
        between(from.height, to.height),
    );
    scene.method = Method {
        points: between(from.method.points, to.method.points),
        squares: between(from.method.squares, to.method.squares),
        picture: between(from.method.picture, to.method.picture),
    };
}

/// A camera that looks at a point from a level distance, at an angle about it and from a height above it.
pub(super) fn orbit(look_at: Vec3A, angle: f32, distance: f32, height: f32) -> Camera {
    let away = vec3a(distance * sin(angle), height, -distance * cos(angle));
    Camera {
        eye: look_at + away,
        look_at,
        up: Vec3A::Y,
        field_of_view: core::f32::consts::FRAC_PI_4,
    }
}
