//! The cylinder with flat ends, along the block's own y axis.

use super::cuboid::Span;
use crate::lanes::*;
use glam::Vec3;

#[inline(always)]
pub(super) fn span<S: Isa>(simd: S, half: Vec3, o: &Vec3x<S>, d: &Vec3x<S>) -> Span<S> {
    Span::slab(simd, o.y, d.y, half.y).and(endless(simd, half.x, o, d))
}

#[inline(always)]
pub(super) fn endless<S: Isa>(simd: S, radius: f32, o: &Vec3x<S>, d: &Vec3x<S>) -> Span<S> {
    let zero = splat(simd, 0.0);
    let a: F<S> = d.x * d.x + d.z * d.z;
    let b: F<S> = d.x * o.x + d.z * o.z;
    let middle = -b / a;
    // The perpendicular to the axis loses no digits far away.
    let x: F<S> = o.x + d.x * middle;
    let z: F<S> = o.z + d.z * middle;
    let off2: F<S> = x * x + z * z;
    let chord2 = -off2 + radius * radius;
    let chord = (at_least::<S>(chord2, zero) / a).sqrt();
    Span { near: middle - chord, far: middle + chord, is_met: chord2.simd_ge(zero) }
}

#[inline(always)]
pub(super) fn outward<S: Isa>(p: Vec3x<S>) -> Vec3x<S> {
    let round = (p.x * p.x + p.z * p.z).sqrt();
    Vec3x { x: round, y: p.y.abs(), z: round }
}
