//! The bounding cone of a sphere, seen from the eye or from a lamp.

use super::screen::ScreenBounds;
use super::sides::Terms;
use crate::maths::sqrt;
use crate::shapes::sphere::HIT_ERROR;
use glam::{Vec3A, Vec4};

/// The factor that enlarges a sphere: the cosine of its cone grows by more than its rounding, however flat the cone is.
const WIDE: f32 = 1.0 + 1e-6;

/// The sine that is added to a cone's before its tangent planes are computed: more than rounding turns them.
const WIDER: f32 = 1e-4;

/// The cone of rays from a tip that meet a sphere. The tip is outside of the sphere.
#[derive(Clone, Copy)]
pub(super) struct BoundingCone {
    /// The vector from the tip to the sphere's centre.
    to: Vec3A,
    /// The cosine of the angle at the tip, divided by the length of `to`.
    cosine_by_length: f32,
    /// The sine of that angle, divided by the same.
    sine_by_length: f32,
}

impl BoundingCone {
    /// Returns the cone around a sphere whose centre is at `to`; `None` if the tip is inside of the sphere, so that all rays meet it.
    pub fn around(to: Vec3A, radius: f32) -> Option<Self> {
        let distance2 = to.length_squared();
        let radius = radius * WIDE;
        let cosine2 = (distance2 - radius * radius) / distance2;
        (cosine2 >= 0.0).then(|| Self {
            to,
            // `to` is as long as the distance, which the sine has once more.
            cosine_by_length: sqrt(cosine2 / distance2),
            sine_by_length: radius / distance2,
        })
    }

    /// Returns the share of its sine by which rays may be inside and miss the sphere, around which it is wider by `hit_error`.
    ///
    /// Shadow rays have another such error taken from the radius, so that no sphere shadows itself, and one more of the way to the
    /// lamp, see `ShadowCone::r2`; the points that they leave from are off by less than a third one.
    #[inline(never)]
    pub fn unsure(&self, hit_error: f32) -> f32 {
        let distance2 = self.to.length_squared();
        let (radius, cosine2) = (
            self.sine_by_length * distance2,
            self.cosine_by_length * self.cosine_by_length * distance2,
        );
        let error = 3.0 * (hit_error + HIT_ERROR * sqrt(distance2));
        error / (radius * cosine2)
    }

    /// Returns the cone's terms as functions of u and v, where `rays` are the cone's rays for a step along u, along v, and for (0, 0).
    #[inline(never)]
    pub fn terms(&self, rays: &[Vec3A; 3]) -> Terms {
        rays.map(|ray| {
            let cosine = self.to.cross(ray) * self.cosine_by_length;
            cosine.extend(self.to.dot(ray) * self.sine_by_length)
        })
    }

    /// Returns its bounds in the picture, if the planes through the tip with three normals are seen as the lines u = 0, v = 0, and
    /// the line at infinity: the camera's axes, where the tip is the eye.
    ///
    /// The line u = c is the plane that has the first normal less c times the last. It touches the cone where its angle with the
    /// axis is the cone's own (Mara and McGuire: 2D Polyhedral Bounds of a Clipped, Perspective-Projected 3D Sphere, JCGT 2013,
    /// where normals are at right angles to each other).
    #[inline(never)]
    pub fn bounds(&self, [right, down, forward]: &[Vec3A; 3], pixel: f32) -> ScreenBounds {
        let distance = self.to.length();
        let (axis, sine) = (self.to / distance, self.sine_by_length * distance + WIDER);
        let ahead = axis.dot(*forward);
        if ahead < -sine * forward.length() {
            return ScreenBounds::NONE;
        }
        let [u, v] = [right, down].map(|normal| {
            // All planes have one direction in common. Across it the cone is as wide as a flat one.
            let along = normal.cross(*forward).normalize();
            let shared = axis.dot(along);
            let cosine = sqrt(1.0 - sine * sine - shared * shared);
            let across = along.cross(axis) * sine;
            Vec4::new(
                normal.dot(across),
                cosine * axis.dot(*normal),
                forward.dot(across),
                cosine * ahead,
            )
        });
        ScreenBounds::around(u, v, pixel)
    }
}
