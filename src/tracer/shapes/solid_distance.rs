//! Signed distances of points from blocks, and the points of rays nearest to blocks.

use super::block::along;
use super::{cuboid, cylinder};
use crate::lanes::*;
use crate::scene::{Block, Shape};
use glam::Vec3A;

/// Returns the distances along rays, 0 to `limit`, where they come nearest to a block, and their
/// depths there, negative outside.
///
/// The result is approximate: the middle of the ray's interval between the block's faces, moved
/// once towards the block. If a ray misses the block along a face, the interval may be far away.
#[inline(always)]
pub(crate) fn approach<S: Isa>(
    simd: S,
    block: &Block,
    o: &Vec3x<S>,
    d: &Vec3x<S>,
    limit: F<S>,
) -> (F<S>, F<S>) {
    let zero = splat(simd, 0.0);
    let o = along(simd, &block.axes, &(*o - Vec3x::splat(simd, block.centre)));
    let d = along(simd, &block.axes, d) + Vec3x::splat(simd, Vec3A::splat(super::block::TINY));
    let span = match block.shape {
        Shape::Box => cuboid::span(simd, block.half, &o, &d),
        Shape::Cylinder | Shape::Capsule => cylinder::span(simd, block.half, &o, &d),
    };
    let mut moved = (span.near + span.far) * 0.5;
    let (mut distance, mut t) = (zero, zero);
    // A loop compiles the distance once.
    for _ in 0..2 {
        t = clamp::<S>(moved, zero, limit);
        let outside = outside(simd, block, &o.add_scaled(d, t));
        distance = outside.distance;
        moved = t - d.dot(outside.out);
    }
    (t, -distance)
}

pub(crate) struct Outside<S: Isa> {
    /// From the nearest point of the block, along its axes; 0 inside.
    pub out: Vec3x<S>,
    /// Negative inside.
    pub distance: F<S>,
}

#[inline(always)]
pub(crate) fn outside<S: Isa>(simd: S, block: &Block, p: &Vec3x<S>) -> Outside<S> {
    let zero = splat(simd, 0.0);
    let half = block.half;
    let is_capsule = block.shape == Shape::Capsule;
    let end = if is_capsule { half.y - half.x } else { half.y };
    let upright = beyond(simd, p.y, end);
    let (out, deepest) = if block.shape == Shape::Box {
        let out = Vec3x { x: beyond(simd, p.x, half.x), y: upright, z: beyond(simd, p.z, half.z) };
        (out, (p.x.abs() - half.x).max(p.z.abs() - half.z))
    } else {
        // From the axis, or a capsule's core.
        let core = if is_capsule { upright } else { zero };
        let length = at_least::<S>(
            (p.x * p.x + p.z * p.z + core * core).sqrt(),
            splat(simd, f32::MIN_POSITIVE),
        );
        let over = length - half.x;
        let share = at_least::<S>(over, zero) / length;
        let out = Vec3x {
            x: p.x * share,
            y: if is_capsule { upright * share } else { upright },
            z: p.z * share,
        };
        (out, over)
    };
    let deepest = deepest.max(p.y.abs() - half.y);
    Outside { out, distance: out.dot(out).sqrt() + at_most::<S>(deepest, zero) }
}

#[inline(always)]
fn beyond<S: Isa>(simd: S, c: F<S>, half: f32) -> F<S> {
    c - clamp::<S>(c, splat(simd, -half), splat(simd, half))
}
