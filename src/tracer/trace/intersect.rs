//! What a packet hits first: planes, the tree's spheres, and blocks by their bounding spheres. Coordinates are the scene's.

use super::candidates::Candidates;
use super::rays::Rays;
use crate::lanes::*;
use crate::prepare::{BvhNode, GroupSet, Object, ObjectId, Prepared, Rectangle};
use crate::shapes::block;

/// The distance that stands for no hit.
const FARTHEST: f32 = 1e30;

/// A bound on the rounding error of the squared dot product of two directions.
const ROUNDING: f32 = 4e-6;

/// Without fused multiply-add, a bound on the error of the squared perpendicular before it is [refined](Chord::refined), as a
/// share of the square of `t_mid`.
///
/// With `u = 2^-24`, rounding the product `d t_mid` displaces the perpendicular by `u t_mid`, and rounding `t_mid` itself lengthens it
/// along the ray by less than `5 u t_mid`. For a ray that meets a sphere of radius `r`,
/// `(r + u t)^2 <= r^2 (1 + m) + u^2 t^2 (1 + 1 / m)`. With `m = 0.001`, for which [`BvhNode::cull2`] makes room, and the square of the
/// 5, that is `(1001 + 25) u^2 = 3.6e-12`.
const UNREFINED: f32 = 4e-12;

/// The nearest hit of each ray.
#[derive(Clone, Copy)]
pub(crate) struct Hit<S: Isa> {
    /// Distance, in lengths of the ray's direction.
    pub t: F<S>,
    /// The object, as [`ObjectId::lane`].
    pub object: U<S>,
}

impl<S: Isa> Hit<S> {
    /// Replaces the hits in the lanes of a mask.
    #[inline(always)]
    pub fn keep_nearer(&mut self, nearer: M<S>, t: F<S>, object: ObjectId) {
        self.t = nearer.select(t, self.t);
        self.object = nearer.select(U::<S>::splat(self.t.token(), object.lane()), self.object);
    }
}

/// The nearest hits among all planes and the spheres of some groups. Boxes and cylinders that may be hit become candidates.
#[inline(always)]
pub(crate) fn nearest<S: Isa>(
    simd: S,
    scene: &Prepared,
    rays: &Rays<S>,
    groups: GroupSet,
    candidates: &mut Candidates,
) -> Hit<S> {
    candidates.clear();
    let mut hit = Hit {
        t: splat(simd, FARTHEST),
        object: U::<S>::splat(simd, ObjectId::new(scene.background()).lane()),
    };
    for (i, plane) in scene.planes().iter().enumerate() {
        let (m, t) = plane_hit(simd, plane, rays.o, rays.d, hit.t);
        hit.keep_nearer(m, t, ObjectId::new(scene.first_plane() + i));
    }
    let nodes = scene.tree.nodes();
    let mut i = scene.tree.start(groups);
    while let Some(node) = nodes.get(i) {
        let mut is_met = node.groups & groups != 0;
        if is_met {
            let quick = Chord::new(simd, rays, node);
            let near = quick.may_be_ahead(node);
            is_met = near.any_true();
            if is_met && !node.is_bound {
                let chord = quick.refined(rays.d);
                if node.is_block {
                    let near = near & !chord.is_off(rays.d, node, hit.t);
                    if near.any_true() {
                        candidates.push::<S>(node.object, near);
                    }
                } else {
                    let (m, t) = chord.entry(near, node, hit.t);
                    hit.keep_nearer(m, t, node.object);
                }
            }
        }
        i += node.step(is_met);
    }
    hit
}

/// Intersects rays with the boxes and cylinders among their candidates, and keeps hits that are nearer.
#[inline(always)]
pub(super) fn resolve_blocks<S: Isa>(
    simd: S,
    scene: &Prepared,
    rays: &Rays<S>,
    candidates: &Candidates,
    hit: &mut Hit<S>,
) {
    for &candidate in candidates.as_slice() {
        if let Object::Block(block) = scene.object(candidate.object).0 {
            let t = block::distance(simd, block, &rays.o, &rays.d);
            let is_nearer = t.simd_lt(hit.t) & candidate.lanes(simd);
            hit.keep_nearer(is_nearer, t, candidate.object);
        }
    }
}

/// The chord of a ray's line inside of a sphere.
struct Chord<S: Isa> {
    /// The vector from the ray's origin to the sphere's centre.
    f: Vec3x<S>,
    /// The distance from the ray's origin to the middle of the chord, which is the point nearest to the centre; negative behind
    /// the origin.
    t_mid: F<S>,
    /// The perpendicular, from the centre to the middle of the chord.
    l: Vec3x<S>,
    /// Its length squared.
    l2: F<S>,
}

impl<S: Isa> Chord<S> {
    /// The chord's length comes from the perpendicular from the centre to the ray, which loses no digits when the
    /// sphere is small and far away (Haines, Günther, Akenine-Möller: Precision Improvements for Ray/Sphere
    /// Intersection, Ray Tracing Gems, 2019).
    #[inline(always)]
    fn new(simd: S, rays: &Rays<S>, node: &BvhNode) -> Self {
        let f = Vec3x::splat(simd, node.centre) - rays.o;
        let t_mid = f.dot(rays.d);
        let l = rays.d.scaled_minus(t_mid, f);
        let l2 = l.dot(l);
        Self { f, t_mid, l, l2 }
    }

    /// The same chord with a perpendicular that is as accurate without fused multiply-add as with it.
    ///
    /// Without it the product `d t_mid`, which is as long as the distance to the sphere, is rounded before all but the
    /// perpendicular cancels. So both factors are split into halves of 12 bits, whose products are exact (Dekker: A
    /// Floating-Point Technique for Extending the Available Precision, Numerische Mathematik 18, 1971). Only the last product is
    /// rounded, which is smaller by 2^12. Most rays miss most spheres clearly, so this is only computed for spheres that [may be
    /// ahead](Chord::may_be_ahead).
    #[inline(always)]
    fn refined(self, d: Vec3x<S>) -> Self {
        if S::FUSES_MUL_ADD {
            return self;
        }
        let d_high = Vec3x {
            x: upper_half::<S>(d.x),
            y: upper_half::<S>(d.y),
            z: upper_half::<S>(d.z),
        };
        let d_low = d - d_high;
        let t_high = upper_half::<S>(self.t_mid);
        let t_low = self.t_mid - t_high;
        let l = d_high
            .scaled_minus(t_high, self.f)
            .add_scaled(d_high, t_low)
            .add_scaled(d_low, self.t_mid);
        let l2 = l.dot(l);
        Self { l, l2, ..self }
    }

    /// Which rays may hit the sphere: all that do, and some that pass by closely, or that start on it and leave it.
    #[inline(always)]
    fn may_be_ahead(&self, node: &BvhNode) -> M<S> {
        let simd = self.t_mid.token();
        let unsure = if S::FUSES_MUL_ADD {
            splat(simd, 0.0)
        } else {
            self.t_mid * splat(simd, -UNREFINED)
        };
        // The far end is ahead if the middle is, or if half the chord is longer than the distance back to the middle.
        let back2 = at_most::<S>(self.t_mid, unsure) * self.t_mid;
        (splat(simd, node.cull2) - self.l2).simd_ge(back2)
    }

    /// Which rays along `d` certainly miss the box or the cylinder inside of the sphere, or hit it beyond `limit`: they pass its
    /// longer axis at more than its thickness, or end before the sphere.
    #[inline(always)]
    fn is_off(&self, d: Vec3x<S>, node: &BvhNode, limit: F<S>) -> M<S> {
        let simd = self.t_mid.token();
        let axis = Vec3x::splat(simd, node.axis);
        let (along, across) = (d.dot(axis), self.l.dot(axis));
        // The squared sine of the angle between ray and axis, reduced by the rounding error. Squared distances are compared after
        // multiplication with it.
        let sine2 = splat::<S>(simd, 1.0 - ROUNDING) - along * along;
        let beyond = self.l2 - node.thin2;
        let is_off = (beyond * at_least::<S>(sine2, splat(simd, 0.0))).simd_gt(across * across);
        is_off | self.t_mid.simd_gt(limit + node.radius)
    }

    /// The nearest end of the chord that is ahead and nearer than `limit`.
    ///
    /// Due to rounding, a ray that starts on the sphere starts slightly inside or outside of it. If its origin is off the sphere
    /// by no more than [`BvhNode::hit_error`], it counts as starting on it: outward it does not hit the sphere, inward it hits
    /// the far side.
    #[inline(always)]
    fn entry(&self, mask: M<S>, node: &BvhNode, limit: F<S>) -> (M<S>, F<S>) {
        let simd = self.t_mid.token();
        let r2_error = splat(simd, node.r2_error);
        // The squared half chord. For rays that miss the sphere it is negative, its root is NaN, and all comparisons fail.
        let discriminant = splat::<S>(simd, node.r2) - self.l2;
        // The squared distance of the origin from the centre, minus the squared radius.
        let start = self.t_mid.mul_add(self.t_mid, -discriminant);
        let is_inward = self.t_mid.simd_gt(splat(simd, node.hit_error));
        let is_ahead = is_inward | start.simd_lt(-r2_error);
        let half = discriminant.sqrt();
        // Rays that start outside enter at the near end.
        let sign =
            U::<S>::splat(simd, 1 << 31) & start.simd_gt(r2_error).to_vector().bitcast::<U<S>>();
        let t = flipped::<S>(half, sign) + self.t_mid;
        (mask & is_ahead & t.simd_lt(limit), t)
    }
}

/// The upper 12 bits of a number's mantissa.
#[inline(always)]
fn upper_half<S: Isa>(c: F<S>) -> F<S> {
    (c.bitcast::<U<S>>() & 0xffff_f000).bitcast()
}

/// Which rays hit a plane nearer than `limit`, and where.
#[inline(always)]
pub(super) fn plane_hit<S: Isa>(
    simd: S,
    plane: &Rectangle,
    o: Vec3x<S>,
    d: Vec3x<S>,
    limit: F<S>,
) -> (M<S>, F<S>) {
    let [x, y, z] = plane.centre.to_array();
    // For rays parallel to the plane this is infinite or NaN, and the comparisons below fail.
    let t = (splat(simd, y) - o.y) / d.y;
    let across = t.mul_add(d.x, o.x - x).abs();
    let along = t.mul_add(d.z, o.z - z).abs();
    // The origin of a ray that starts on the plane is exact, so its t is 0, which is not above 0.
    let hit = t.simd_gt(splat(simd, 0.0))
        & t.simd_lt(limit)
        & across.simd_le(splat(simd, plane.half_x))
        & along.simd_le(splat(simd, plane.half_z));
    (hit, t)
}
