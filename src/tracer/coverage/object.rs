//! Objects in the eye's own sight: their bounds in the picture, and which of two occludes the other.

use super::screen::ScreenBounds;
use super::{Coverage, Outline};
use crate::lanes::*;
use crate::maths::sqrt;
use crate::prepare::{BvhNode, Object, ObjectId, World};
use crate::rounding::{CORNER, HIT, SEEN, TOUCHING, hit_error};
use crate::scene::Block;
use glam::{Mat3A, Vec3A, Vec4};

/// Conservative bounds of an object.
pub(super) struct ObjectBounds {
    /// The number of a solid's or a light's node in the tree.
    pub node: u16,
    pub screen: ScreenBounds,
    /// Bounds of a sphere's power of the eye, distance squared minus radius squared, infinite around the eye; `None` where the eye may
    /// be inside or outside, and for other objects. Of two spheres the one with the smaller power is in front wherever both are, since
    /// the plane of equal powers separates their visible parts (Aurenhammer: Power Diagrams, SIAM Journal on Computing, 1987).
    power: Option<[f32; 2]>,
    /// Half of its least extent.
    pub thickness: f32,
    /// The ends of its extent along the scene's axes, and forward from the eye.
    ///
    /// Along the axes these are the scene's own numbers, where they are exact: an object that stands on another one, or rises out of it
    /// by the last digit of its height, does so here.
    least: Vec4,
    most: Vec4,
}

impl ObjectBounds {
    /// All zeros.
    pub const ZERO: Self = Self {
        node: 0,
        screen: ScreenBounds::ZERO,
        power: None,
        thickness: 0.0,
        least: Vec4::ZERO,
        most: Vec4::ZERO,
    };

    /// Returns [`hit_error`] of the object.
    #[inline(never)]
    pub fn hit_error(&self) -> f32 {
        let reach = self.least.abs().max(self.most.abs());
        hit_error(Vec3A::from_vec4(reach), 0.0)
    }

    /// Returns whether its extent is finite.
    pub fn is_finite(&self) -> bool {
        self.most.is_finite()
    }

    /// Returns how far it reaches above a height, least and most.
    pub fn above(&self, height: f32) -> [f32; 2] {
        [self.least.y - height, self.most.y - height]
    }

    /// Returns whether a plane across an axis separates the object from the eye and from four points, given by their vectors from the
    /// eye and their distances forward. These are off by `slack` at most.
    pub fn is_beyond(&self, eye: Vec3A, points: [F<Baseline>; 4], slack: f32) -> bool {
        let [least, most] = [self.least, self.most].map(|end| end - eye.extend(0.0));
        let gaps = least.max(-most) - (least.abs() + most.abs()) * SEEN - slack;
        let axes = points.into_iter().enumerate();
        axes.fold(false, |is_beyond, (i, along)| {
            let along = if most[i] < 0.0 { -along } else { along };
            is_beyond | (gaps[i] >= 0.0) & along.simd_le(splat(along.token(), gaps[i])).all_true()
        })
    }

    /// Returns whether a point is sure to be outside.
    pub fn is_beside(&self, point: Vec4) -> bool {
        let is_beside = self.least.cmpgt(point) | self.most.cmplt(point);
        is_beside.bitmask() & 0b111 != 0
    }
}

/// Returns the bounds of a sphere's power, see [`ObjectBounds::power`]. `to` is its centre from the eye.
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

/// Returns how far a block reaches from its centre along the scene's axes and forward.
fn extent(block: &Block, forward: Vec3A) -> Vec4 {
    let inward = Mat3A::from(block.axes).transpose();
    let half = Vec3A::from(block.half);
    let own = [
        inward.x_axis,
        inward.y_axis,
        inward.z_axis,
        inward * forward,
    ];
    Vec4::from(own.map(|axis| {
        // Exact along an axis of its own, and larger by what axes may be off elsewhere.
        let tilt = (axis.abs().element_sum() - 1.0).abs();
        axis.abs().dot(half) + CORNER.min(4.0 * tilt) * half.element_sum()
    }))
}

impl Coverage {
    /// Sets the bounds of all objects.
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
                _ => (
                    power(node.centre - world.eye, node),
                    node.radius,
                    Vec4::splat(node.radius),
                ),
            };
            let [least, most] = ends(node.centre, extent);
            let object = ObjectBounds {
                node: number as u16,
                screen: if most.is_finite() {
                    screen
                } else {
                    ScreenBounds::NONE
                },
                power,
                thickness,
                least,
                most,
            };
            let width = 2.0 * object.thickness / self.eye.reach(node.centre, node.radius);
            self.list(Outline::Object(node.object), object.screen, width);
            self.objects[node.object.index()] = object;
        }
        for (i, plane) in world.planes().iter().enumerate() {
            let id = ObjectId::new(world.first_plane() + i);
            // Forward it is nowhere before or behind anything.
            let extent = Vec4::new(plane.half_x, 0.0, plane.half_z, 1e30);
            let [least, most] = ends(plane.centre.into(), extent);
            self.objects[id.index()] = ObjectBounds {
                screen: ScreenBounds::ALL,
                least,
                most,
                ..ObjectBounds::ZERO
            };
            let (half, centre) = (Vec3A::from_vec4(extent), plane.centre.into());
            let far = self.eye.reach(centre, half.length());
            let to = (centre - world.eye).abs();
            // From above it reaches beneath the eye; from beside it is as flat as its far end.
            let is_beside = to.x > half.x || to.z > half.z;
            let steep = if is_beside { to.y / far } else { 1.0 };
            let width = 2.0 * half.x.min(half.z) * steep / far;
            self.list(Outline::Object(id), ScreenBounds::ALL, width);
        }
    }

    /// Returns whether two spheres are in front of each other in this order wherever both are seen, see [`ObjectBounds::power`].
    pub(super) fn has_less_power(&self, front: ObjectId, back: ObjectId) -> bool {
        let power = |id: ObjectId| self.objects[id.index()].power;
        match (power(front), power(back)) {
            (Some([_, front]), Some([back, _])) => front < back,
            _ => false,
        }
    }
}
