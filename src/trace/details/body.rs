//! Rays against boxes and cylinders.

use crate::lanes::*;
use crate::scene::Block;
use glam::{Mat3A, Vec3A};

/// Added to directions, so that none along a side is divided by.
const TINY: f32 = 1e-12;

/// Vectors along three axes, and `least` along each.
#[inline(never)]
fn along<S: Isa>(simd: S, axes: &Mat3A, v: &Vec3x<S>, least: f32) -> Vec3x<S> {
    let along = |axis: Vec3A| -> F<S> { v.dot(Vec3x::splat(simd, axis)) + least };
    Vec3x {
        x: along(axes.x_axis),
        y: along(axes.y_axis),
        z: along(axes.z_axis),
    }
}

/// The distances at which rays first meet a block ahead; infinite where they pass by.
///
/// A ray is inside where it is between all sides at once.
/// Not inlined, for it is called in two places and is none of a kernel.
#[inline(never)]
pub(super) fn first_ahead<S: Isa>(simd: S, block: &Block, o: &Vec3x<S>, d: &Vec3x<S>) -> F<S> {
    let o = along(
        simd,
        &block.axes,
        &(*o - Vec3x::splat(simd, block.centre)),
        0.0,
    );
    let d = along(simd, &block.axes, d, TINY);
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

/// Places on a block's surface, a ray's each.
pub(super) struct Spot<S: Isa> {
    /// From the centre.
    pub out: Vec3x<S>,
    /// The normal there, outward.
    pub n: Vec3x<S>,
    /// From the centre along the block's own axes.
    pub own: Vec3x<S>,
}

impl<S: Isa> Spot<S> {
    /// The places on the surface by those that are off by rounding: on the side that each is least within of.
    #[inline(always)]
    pub fn near(simd: S, block: &Block, out: Vec3x<S>) -> Self {
        let own = along(simd, &block.axes, &out, 0.0);
        // How far out it is, the sides being at 1.
        let sides = own * Vec3x::splat(simd, block.half.recip());
        let (mut x, y, mut z) = (sides.x.abs(), sides.y.abs(), sides.z.abs());
        if block.round {
            x = (x * x + z * z).sqrt();
            z = x;
        }
        let most = x.max(y).max(z);
        let side = |far: F<S>, own: F<S>| far.simd_ge(most).select(own, splat(simd, 0.0));
        let side: Vec3x<S> = Vec3x {
            x: side(x, own.x),
            y: side(y, own.y),
            z: side(z, own.z),
        };
        let length = side.dot(side).sqrt();
        let inverse = splat::<S>(simd, 1.0) / length;
        let n = along(simd, &block.axes.transpose(), &side.scaled(inverse), 0.0);
        // Along the normal to where `most` is 1.
        let out = out.add_scaled(n, length / most - length);
        Self { out, n, own }
    }
}

/// How far from a block's surface rays start that leave it: what rounding can displace a point on it by, in both
/// directions, many times over. Ten units from the origin it is a ten-thousandth.
pub(super) fn slack(block: &Block) -> f32 {
    1e-5 * (block.centre.abs() + block.half).element_sum()
}
