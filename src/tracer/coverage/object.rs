//! An object in direct view.

use super::screen::ScreenBounds;
use crate::lanes::*;
use crate::rounding::{HIT, SURFACE_POINT, hit_error};
use glam::{Vec3A, Vec4};

pub(crate) struct ObjectBounds {
    /// The index of its node in the tree, for solids and lights.
    pub node: u16,
    pub screen: ScreenBounds,
    /// Bounds of the eye's power with respect to a sphere: distance squared minus radius squared, or infinity if the eye is inside. `None`
    /// for blocks, and if rounding decides whether the eye is inside. The plane of equal powers separates the visible parts of two spheres:
    /// the sphere of smaller power is in front (Aurenhammer: Power Diagrams, SIAM Journal on Computing, 1987).
    pub power: Option<[f32; 2]>,
    /// Half of the least extent.
    pub thickness: f32,
    /// The extent along the scene's axes, and forward from the eye.
    pub min: Vec4,
    pub max: Vec4,
}

zero! { ObjectBounds { node, screen, power, thickness, min, max } }

impl ObjectBounds {
    #[inline(never)]
    pub fn hit_error(&self) -> f32 {
        let reach = self.min.abs().max(self.max.abs());
        hit_error(Vec3A::from_vec4(reach), 0.0)
    }

    pub fn is_finite(&self) -> bool {
        self.max.is_finite()
    }

    pub fn above(&self, height: f32) -> [f32; 2] {
        [self.min.y - height, self.max.y - height]
    }

    /// Returns whether a plane perpendicular to an axis separates the object from the eye and from points of the object `front`. `points`
    /// returns their vectors from the eye, and their forward distances.
    pub fn is_beyond(
        &self,
        front: &Self,
        eye: Vec4,
        points: impl FnOnce() -> [F<Baseline>; 4],
    ) -> bool {
        let slack =
            SURFACE_POINT / HIT * (front.hit_error() + hit_error(Vec3A::from_vec4(eye), 0.0));
        let [min, max] = [self.min, self.max].map(|end| end - eye);
        let gaps = min.max(-max) - (min.abs() + max.abs()) * SURFACE_POINT - slack;
        let is_negative = max.cmplt(Vec4::ZERO);
        let reach = Vec4::select(is_negative, eye - front.min, front.max - eye);
        let is_gap = gaps.cmpge(Vec4::ZERO);
        // All of `front` is on the eye's side.
        if (is_gap & reach.cmple(gaps)).any() {
            return true;
        }
        let axes = points().into_iter().enumerate();
        axes.fold(false, |is_beyond, (i, along)| {
            let along = if max[i] < 0.0 { -along } else { along };
            is_beyond | (gaps[i] >= 0.0) & along.simd_le(gaps[i]).all_true()
        })
    }

    pub fn excludes(&self, point: Vec4) -> bool {
        let is_outside = self.min.cmpgt(point) | self.max.cmplt(point);
        is_outside.bitmask() & 0b111 != 0
    }
}
