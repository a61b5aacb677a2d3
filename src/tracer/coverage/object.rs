//! Objects in direct view: their bounds in the picture, and the order of occluders.

use super::bounds::{Coverage, ObjectBounds, Outline};
use super::screen::ScreenBounds;
use crate::lanes::*;
use crate::maths::sqrt;
use crate::prepare::{BvhNode, Object, ObjectId, World};
use crate::rounding::{CORNER, HIT, SURFACE_POINT, TOUCHING, hit_error};
use crate::scene::Block;
use crate::zero::Zero;
use glam::{Mat3A, Vec3A, Vec4};

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

    /// Returns whether a plane perpendicular to an axis separates the object from the eye and from
    /// points of the object `front`. `points` returns their vectors from the eye, and their forward
    /// distances.
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

/// `to` is the vector from the eye to the sphere's centre.
fn power(to: Vec3A, node: &BvhNode) -> Option<[f32; 2]> {
    let radius = node.radius;
    let distance2 = to.length_squared();
    let power = distance2 - radius * radius;
    let unsure = HIT * (distance2 + radius * radius);
    let is_sure = (sqrt(distance2) - radius).abs() > TOUCHING * node.hit_error;
    is_sure.then_some(if power < 0.0 {
        [f32::INFINITY; 2]
    } else {
        [power - unsure, power + unsure]
    })
}

fn extent(block: &Block, forward: Vec3A) -> Vec4 {
    let inward = Mat3A::from(block.axes).transpose();
    let half = Vec3A::from(block.half);
    let own = [inward.x_axis, inward.y_axis, inward.z_axis, inward * forward];
    Vec4::from(own.map(|axis| {
        // Aligned axes are exact; others get a margin for their error.
        let tilt = (axis.abs().element_sum() - 1.0).abs();
        axis.abs().dot(half) + CORNER.min(4.0 * tilt) * half.element_sum()
    }))
}

impl Coverage {
    pub(super) fn set_objects(&mut self, world: World<'_>) {
        let forward = self.axes.rows[2];
        let ends = |centre: Vec3A, extent: Vec4| {
            let centre = centre.extend((centre - world.eye).dot(forward));
            [centre - extent, centre + extent]
        };
        for (number, node) in world.tree.objects() {
            let screen = self.eye.screen(node, self.axes.pixel);
            self.groups[0][node.group()].join(screen);
            let (power, thickness, extent) = match world.object(node.object).0 {
                Object::Block(block) => (None, block.half.min_element(), extent(block, forward)),
                _ => (power(node.centre - world.eye, node), node.radius, Vec4::splat(node.radius)),
            };
            let [min, max] = ends(node.centre, extent);
            let object = ObjectBounds {
                node: number as u16,
                screen: if max.is_finite() { screen } else { ScreenBounds::NONE },
                power,
                thickness,
                min,
                max,
            };
            let width = 2.0 * object.thickness / self.eye.reach(node.centre, node.radius);
            self.list(Outline::Object(node.object), object.screen, width);
            self.objects[node.object.index()] = object;
        }
        for (i, plane) in world.planes().iter().enumerate() {
            let id = ObjectId::new(world.first_plane() + i);
            // The forward extent counts as unbounded, so that it never puts a plane behind another
            // object.
            let extent = Vec4::new(plane.half_x, 0.0, plane.half_z, 1e30);
            let [min, max] = ends(plane.centre.into(), extent);
            self.objects[id.index()] =
                ObjectBounds { screen: ScreenBounds::ALL, min, max, ..ObjectBounds::ZERO };
            let (half, centre) = (Vec3A::from_vec4(extent), plane.centre.into());
            let far = self.eye.reach(centre, half.length());
            let to = (centre - world.eye).abs();
            // An eye above the rectangle may look straight down. From outside, the angle is least
            // at the far end.
            let is_beside = to.x > half.x || to.z > half.z;
            let steep = if is_beside { to.y / far } else { 1.0 };
            let width = 2.0 * half.x.min(half.z) * steep / far;
            self.list(Outline::Object(id), ScreenBounds::ALL, width);
        }
    }

    /// Returns whether the sphere `front` is before the sphere `back` on all rays that meet both,
    /// see [`ObjectBounds::power`]. If the eye is inside `back`, this holds only where the eye sees
    /// `front`.
    pub fn has_less_power(&self, front: ObjectId, back: ObjectId) -> bool {
        let power = |id: ObjectId| self.objects[id.index()].power;
        match (power(front), power(back)) {
            (Some([_, front]), Some([back, _])) => front < back,
            _ => false,
        }
    }
}
