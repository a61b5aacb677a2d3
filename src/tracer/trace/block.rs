//! Intersections of rays with boxes and cylinders. Coordinates are the scene's, unless they are along a block's own axes.

use super::candidates::Candidates;
use super::intersect::Hit;
use super::rays::Rays;
use crate::lanes::*;
use crate::prepare::{Object, Prepared};
use crate::scene::{Block, Shape};
use glam::{Mat3A, Vec3A};

/// Added to directions along a block's axes, to avoid divisions by 0 for rays that are parallel to a side.
const TINY: f32 = 1e-12;

/// A vector's components along three axes.
#[inline(always)]
fn along<S: Isa>(simd: S, axes: &Mat3A, v: &Vec3x<S>) -> Vec3x<S> {
    Vec3x {
        x: v.dot(Vec3x::splat(simd, axes.x_axis)),
        y: v.dot(Vec3x::splat(simd, axes.y_axis)),
        z: v.dot(Vec3x::splat(simd, axes.z_axis)),
    }
}

/// The distances at which rays enter and leave the slab within `half` of the centre along one axis. `o` and `d` are the rays'
/// origins and directions along that axis.
#[inline(always)]
fn slab<S: Isa>(simd: S, o: F<S>, d: F<S>, half: f32) -> (F<S>, F<S>) {
    let middle = -o / d;
    let half = (splat(simd, half) / d).abs();
    (middle - half, middle + half)
}

/// The distances at which rays first hit a block; infinite for rays that miss it.
///
/// A ray is inside of the block while it is inside of all slabs (Kay and Kajiya: Ray Tracing Complex Scenes, SIGGRAPH 1986).
#[inline(always)]
pub(super) fn distance<S: Isa>(simd: S, block: &Block, o: &Vec3x<S>, d: &Vec3x<S>) -> F<S> {
    let tiny = Vec3x::splat(simd, Vec3A::splat(TINY));
    let o = along(simd, &block.axes, &(*o - Vec3x::splat(simd, block.centre)));
    let d = along(simd, &block.axes, d) + tiny;
    let zero = splat(simd, 0.0);
    let (mut near, mut far) = slab(simd, o.y, d.y, block.half.y);
    let mut is_met = M::<S>::splat(simd, true);
    match block.shape {
        Shape::Box => {
            for (o, d, half) in [(o.x, d.x, block.half.x), (o.z, d.z, block.half.z)] {
                let (enters, leaves) = slab(simd, o, d, half);
                near = at_least::<S>(near, enters);
                far = at_most::<S>(far, leaves);
            }
        }
        Shape::Cylinder => {
            let a: F<S> = d.x * d.x + d.z * d.z;
            let b: F<S> = d.x * o.x + d.z * o.z;
            let middle = -b / a;
            // The squared half chord, computed from the perpendicular to the axis, which loses no digits far away.
            let x: F<S> = o.x + d.x * middle;
            let z: F<S> = o.z + d.z * middle;
            let off2: F<S> = x * x + z * z;
            let chord2 = -off2 + block.half.x * block.half.x;
            is_met = chord2.simd_ge(zero);
            let half = (at_least::<S>(chord2, zero) / a).sqrt();
            near = at_least::<S>(near, middle - half);
            far = at_most::<S>(far, middle + half);
        }
    }
    let t = near.simd_gt(zero).select(near, far);
    is_met &= near.simd_le(far) & t.simd_gt(zero);
    is_met.select(t, splat(simd, f32::INFINITY))
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
            let t = distance(simd, block, &rays.o, &rays.d);
            let is_nearer = t.simd_lt(hit.t) & candidate.lanes(simd);
            hit.keep_nearer(is_nearer, t, candidate.object);
        }
    }
}

/// Points on the surface of a block, one per ray.
pub(super) struct BlockHit<S: Isa> {
    /// From the centre, in scene coordinates.
    pub out: Vec3x<S>,
    /// The normal, outward, of length 1.
    pub n: Vec3x<S>,
    /// From the centre, along the block's own axes.
    pub own: Vec3x<S>,
}

impl<S: Isa> BlockHit<S> {
    /// Projects points that rounding has taken off the surface, `out` from the centre, to the nearest face.
    #[inline(always)]
    pub fn near(simd: S, block: &Block, out: Vec3x<S>) -> Self {
        let own = along(simd, &block.axes, &out);
        // The coordinates relative to the faces, which are at -1 and 1.
        let faces = own * Vec3x::splat(simd, block.half.recip());
        let (mut x, y, mut z) = (faces.x.abs(), faces.y.abs(), faces.z.abs());
        match block.shape {
            Shape::Box => {}
            Shape::Cylinder => {
                x = (x * x + z * z).sqrt();
                z = x;
            }
        }
        let farthest = at_least::<S>(at_least::<S>(x, y), z);
        let zero = splat(simd, 0.0);
        let face: Vec3x<S> = Vec3x {
            x: x.simd_ge(farthest).select(own.x, zero),
            y: y.simd_ge(farthest).select(own.y, zero),
            z: z.simd_ge(farthest).select(own.z, zero),
        };
        let length = face.dot(face).sqrt();
        let inverse = splat::<S>(simd, 1.0) / length;
        let n = along(simd, &block.axes.transpose(), &face.scaled(inverse));
        let out = out.add_scaled(n, length / farthest - length);
        Self { out, n, own }
    }
}

/// The offset from the surface at which secondary rays of a block start, in scene units: many times the rounding error of a point
/// on it. At ten units from the origin it is 1e-4.
pub(super) fn hit_error(block: &Block) -> f32 {
    1e-5 * (block.centre.abs() + block.half).element_sum()
}
