//! Rays against boxes and cylinders.

use crate::lanes::*;
use crate::scene::Block;
use glam::Vec3A;

/// Added to directions, so that none along a side is divided by.
const TINY: f32 = 1e-12;

/// 1 where a cylinder is round.
const AROUND: Vec3A = Vec3A::new(1.0, 0.0, 1.0);

/// A vector along a block's own axes.
#[inline(never)]
fn inward(block: &Block, v: Vec3A) -> Vec3A {
    block.axes.transpose() * v
}

/// The distances at which rays first meet a block ahead; infinite where they pass by.
///
/// A ray is inside where it is between all sides at once.
/// Not inlined, for it is called in two places and is none of a kernel.
#[inline(never)]
pub(super) fn first_ahead<S: Isa>(simd: S, block: &Block, o: &Vec3x<S>, d: &Vec3x<S>) -> F<S> {
    let along = |v: Vec3x<S>, least: f32| -> Vec3x<S> {
        let axis = |axis: Vec3A| -> F<S> { v.dot(Vec3x::splat(simd, axis)) + least };
        Vec3x {
            x: axis(block.axes.x_axis),
            y: axis(block.axes.y_axis),
            z: axis(block.axes.z_axis),
        }
    };
    let o = along(*o - Vec3x::splat(simd, block.centre), 0.0);
    let d = along(*d, TINY);
    let between = |o: F<S>, d: F<S>, half: f32| {
        let middle = -o / d;
        let half = (splat(simd, half) / d).abs();
        (middle - half, middle + half)
    };
    let zero = splat(simd, 0.0);
    let (mut near, mut far) = between(o.y, d.y, block.half.y);
    let mut is_met = M::<S>::splat(simd, true);
    if block.round {
        let a: F<S> = d.x * d.x + d.z * d.z;
        let along: F<S> = d.x * o.x + d.z * o.z;
        let middle = -along / a;
        // The square of half the chord from the perpendicular to the axis, which loses no digits far away.
        let x: F<S> = o.x + d.x * middle;
        let z: F<S> = o.z + d.z * middle;
        let off2: F<S> = x * x + z * z;
        let chord2 = -off2 + block.half.x * block.half.x;
        is_met = chord2.simd_ge(zero);
        let half = (chord2.max(zero) / a).sqrt();
        near = near.max(middle - half);
        far = far.min(middle + half);
    } else {
        for (o, d, half) in [(o.x, d.x, block.half.x), (o.z, d.z, block.half.z)] {
            let (enters, leaves) = between(o, d, half);
            near = near.max(enters);
            far = far.min(leaves);
        }
    }
    let t = near.simd_gt(zero).select(near, far);
    is_met &= near.simd_le(far) & t.simd_gt(zero);
    is_met.select(t, splat(simd, f32::INFINITY))
}

/// A place on a block's surface.
pub(super) struct Spot {
    /// From the centre.
    pub out: Vec3A,
    /// The normal there, outward.
    pub n: Vec3A,
    /// From the centre along the block's own axes.
    pub own: Vec3A,
}

impl Spot {
    /// The place on the surface by one that is off by rounding: on the side that it is least within of.
    pub fn near(block: &Block, out: Vec3A) -> Self {
        let own = inward(block, out);
        // How far out it is, the sides being at 1.
        let mut sides = (own / block.half).abs();
        if block.round {
            sides = AROUND * (sides * AROUND).length() + sides * Vec3A::Y;
        }
        let most = sides.max_element();
        let side = Vec3A::select(sides.cmpge(Vec3A::splat(most)), own, Vec3A::ZERO);
        let length = side.length();
        let n = block.axes * side / length;
        // Along the normal to where `most` is 1.
        let out = out + n * (length / most - length);
        Self { out, n, own }
    }
}

/// How far from a block's surface rays start that leave it: what rounding can displace a point on it by, in both
/// directions, many times over. Ten units from the origin it is a ten-thousandth.
pub(super) fn slack(block: &Block) -> f32 {
    1e-5 * (block.centre.abs() + block.half).element_sum()
}
