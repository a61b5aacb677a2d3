//! Points of view: the eye, its mirror image, and lamps.

use super::cone::BoundingCone;
use super::screen::ScreenBounds;
use super::sides::{CORNER, Sides};
use crate::prepare::{BvhNode, Object};
use glam::Vec3A;

/// A point that objects are seen from, and its rays through the points of the picture where the eye sees the objects, their images, or
/// their shadows.
#[derive(Clone, Copy)]
pub(super) struct View {
    pub from: Vec3A,
    /// The linear map from the camera's rays (u, v, 1) to the rays from here, up to a factor: its columns for u, v and 1.
    pub rays: [Vec3A; 3],
    /// The normals of the planes through this point that the eye sees as the lines u = 0, v = 0, and the line at infinity.
    pub normals: [Vec3A; 3],
    /// See [`CORNER`].
    pub corner: f32,
    /// The part of a side's [`ROUNDING`](super::sides::ROUNDING) that is allowed for.
    pub rounding: f32,
}

impl View {
    /// All zeros.
    pub const ZERO: Self = Self {
        from: Vec3A::ZERO,
        rays: [Vec3A::ZERO; 3],
        normals: [Vec3A::ZERO; 3],
        corner: 0.0,
        rounding: 0.0,
    };

    /// Returns the view of an eye whose camera has some axes.
    pub fn eye(from: Vec3A, axes: [Vec3A; 3]) -> Self {
        Self {
            from,
            rays: axes,
            normals: axes,
            corner: CORNER,
            rounding: 1.0,
        }
    }

    /// Returns the cone around the bounding sphere of a solid or a light; `None` if this point is inside.
    fn cone(&self, node: &BvhNode) -> Option<BoundingCone> {
        BoundingCone::around(node.centre - self.from, node.radius + node.hit_error)
    }

    /// Returns bounds of a solid or a light in a picture whose pixels are `pixel` wide.
    #[inline(never)]
    pub fn screen(&self, node: &BvhNode, pixel: f32) -> ScreenBounds {
        let cone = self.cone(node);
        cone.map_or(ScreenBounds::ALL, |cone| cone.bounds(&self.normals, pixel))
    }

    /// Returns the rays that meet a solid or a light.
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
