//! Viewpoints (eye, mirrored eye, lights), and the bounding cones of spheres from there.

use super::screen::ScreenBounds;
use super::sides::{Sides, Terms};
use crate::maths::{sqrt, unit};
use crate::prepare::{BvhNode, Object};
use crate::rounding::{CORNER, HIT, UNSURE, WIDE, WIDER};
use glam::{Vec3A, Vec4};

/// A viewpoint, and its rays through the picture.
#[derive(Clone, Copy)]
pub(super) struct View {
    pub from: Vec3A,
    /// The linear map from the camera's rays (u, v, 1) to this view's rays, up to a factor: columns for u, v and 1.
    pub rays: [Vec3A; 3],
    /// The normals of the planes through this point that the picture shows as the lines u = 0, v = 0, and the line at infinity.
    pub normals: [Vec3A; 3],
    pub corner: f32,
    /// The applicable share of [`SIDE`](crate::rounding::SIDE).
    pub rounding: f32,
}

impl View {
    pub const ZERO: Self = Self {
        from: Vec3A::ZERO,
        rays: [Vec3A::ZERO; 3],
        normals: [Vec3A::ZERO; 3],
        corner: 0.0,
        rounding: 0.0,
    };

    pub fn eye(from: Vec3A, axes: [Vec3A; 3]) -> Self {
        Self { from, rays: axes, normals: axes, corner: CORNER, rounding: 1.0 }
    }

    pub fn reach(&self, centre: Vec3A, radius: f32) -> f32 {
        (centre - self.from).length() + radius
    }

    /// Returns the cone around a node's sphere; `None` if this point is inside.
    fn cone(&self, node: &BvhNode) -> Option<BoundingCone> {
        BoundingCone::around(node.centre - self.from, node.radius + node.hit_error)
    }

    #[inline(never)]
    pub fn screen(&self, node: &BvhNode, pixel: f32) -> ScreenBounds {
        let cone = self.cone(node);
        cone.map_or(ScreenBounds::ALL, |cone| cone.bounds(&self.normals, pixel))
    }

    pub fn sides(&self, node: &BvhNode, object: &Object<'_>) -> Sides {
        if let Object::Block(block) = object {
            return Sides::of_block(&self.rays, node.centre - self.from, block, self.corner);
        }
        self.cone(node).map_or(Sides::All, |cone| Sides::Round {
            terms: cone.terms(&self.rays),
            unsure: cone.unsure(node.hit_error),
        })
    }
}

/// The rays from a tip outside a sphere that meet the sphere.
#[derive(Clone, Copy)]
struct BoundingCone {
    to: Vec3A,
    /// The cosine of the angle at the tip, divided by the length of `to`; below, the sine.
    cosine_by_length: f32,
    sine_by_length: f32,
}

impl BoundingCone {
    /// `None` if the tip is inside the sphere.
    pub fn around(to: Vec3A, radius: f32) -> Option<Self> {
        let distance2 = to.length_squared();
        let radius = radius * WIDE;
        let cosine2 = (distance2 - radius * radius) / distance2;
        (cosine2 >= 0.0).then(|| Self {
            to,
            // `to` contains one factor of the distance, the sine two.
            cosine_by_length: sqrt(cosine2 / distance2),
            sine_by_length: radius / distance2,
        })
    }

    /// Returns the margin, relative to the sine, from which rays certainly meet the sphere. The cone is wider by `hit_error`.
    #[inline(never)]
    pub fn unsure(&self, hit_error: f32) -> f32 {
        let distance2 = self.to.length_squared();
        let (radius, cosine2) = (
            self.sine_by_length * distance2,
            self.cosine_by_length * self.cosine_by_length * distance2,
        );
        let error = UNSURE * (hit_error + HIT * sqrt(distance2));
        error / (radius * cosine2)
    }

    /// `rays` are for a step along u, along v, and at (0, 0).
    #[inline(never)]
    pub fn terms(&self, rays: &[Vec3A; 3]) -> Terms {
        rays.map(|ray| {
            let cosine = self.to.cross(ray) * self.cosine_by_length;
            cosine.extend(self.to.dot(ray) * self.sine_by_length)
        })
    }

    /// Returns the cone's bounds, from the normals of the planes that appear as the lines u = 0, v = 0, and the line at infinity: the
    /// camera's axes, if the tip is the eye.
    ///
    /// The plane of u = c has the normal of u minus c times the last one. It touches the cone where its angle with the axis is the cone's
    /// own (Mara and McGuire: 2D Polyhedral Bounds of a Clipped, Perspective-Projected 3D Sphere, JCGT 2013, with orthogonal normals).
    #[inline(never)]
    pub fn bounds(&self, [right, down, forward]: &[Vec3A; 3], pixel: f32) -> ScreenBounds {
        let distance = self.to.length();
        let (axis, sine) = (self.to / distance, self.sine_by_length * distance + WIDER);
        let ahead = axis.dot(*forward);
        if ahead < -sine * forward.length() {
            return ScreenBounds::NONE;
        }
        let [u, v] = [right, down].map(|normal| {
            // All planes share one direction. Across it the problem is two-dimensional.
            let along = unit(normal.cross(*forward));
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
