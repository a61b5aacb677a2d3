//! The camera's movements, in scene coordinates.

use crate::maths::{cos, sin};
use crate::scene::{Camera, Method, Scene};
use glam::{Vec3A, vec3a};

/// The camera and the overlay at the start or the end of a shot. The camera's position is relative to the point it looks at.
#[derive(Clone, Copy)]
pub(super) struct Keyframe {
    /// The point in the middle of the picture, in scene units.
    look_at: Vec3A,
    /// The angle about the y axis in radians. At 0 the camera looks along z.
    angle: f32,
    /// The horizontal distance, in scene units.
    distance: f32,
    /// The height, in scene units.
    height: f32,
    /// The overlay.
    method: Method,
}

/// A keyframe without an overlay.
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
    /// The same keyframe with an overlay, see [`Method`].
    pub const fn overlaid(self, points: f32, squares: f32, picture: f32) -> Self {
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

/// Sets a scene's camera and overlay to the linear interpolation between two keyframes, 0 to 1 from the first to the second. The
/// camera moves on a circle, a spiral or a line.
pub(super) fn interpolate([from, to]: &[Keyframe; 2], u: f32, scene: &mut Scene) {
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

/// A camera that looks at a point; the other arguments are those of a [`Keyframe`].
pub(super) fn orbit(look_at: Vec3A, angle: f32, distance: f32, height: f32) -> Camera {
    let away = vec3a(distance * sin(angle), height, -distance * cos(angle));
    Camera {
        eye: look_at + away,
        look_at,
        up: Vec3A::Y,
        field_of_view: core::f32::consts::FRAC_PI_4,
    }
}
