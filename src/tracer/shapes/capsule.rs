//! The capsule along y: all points within the radius of its core, the axis between the centres of
//! both ends.

use super::cuboid::Span;
use super::cylinder;
use crate::lanes::*;
use glam::Vec3;

/// Returns the intervals of rays inside the capsule, for rays from inside or in the mask `inward`,
/// from 0 to the exit. The intervals of other rays end at the entry.
///
/// The hit is on the sphere around the point of the core that is nearest to the ray's crossing of
/// the infinite cylinder.
#[inline(always)]
pub(super) fn span<S: Isa>(
    simd: S,
    half: Vec3,
    o: &Vec3x<S>,
    d: &Vec3x<S>,
    inward: M<S>,
) -> Span<S> {
    let zero = splat(simd, 0.0);
    let out = from_core(simd, half, o);
    let is_inside = inward | out.dot(out).simd_lt(splat(simd, half.x * half.x));
    let round = cylinder::endless(simd, half.x, o, d);
    let y = is_inside.select(round.far, round.near).mul_add(d.y, o.y);
    let from = Vec3x { y: o.y - nearest(simd, half, y), ..*o };
    let length2 = d.dot(*d);
    let middle = -from.dot(*d) / length2;
    let across = from.add_scaled(*d, middle);
    let half2 = -across.dot(across) + half.x * half.x;
    let chord = (at_least::<S>(half2, zero) / length2).sqrt();
    let t = middle + is_inside.select(chord, -chord);
    // Rounding must not let out a ray that starts inside.
    Span { near: is_inside.select(zero, t), far: t, is_met: half2.simd_ge(zero) | is_inside }
}

#[inline(always)]
fn nearest<S: Isa>(simd: S, half: Vec3, y: F<S>) -> F<S> {
    let end = half.y - half.x;
    clamp::<S>(y, splat(simd, -end), splat(simd, end))
}

/// Returns the vectors from the core to points, and their lengths in radii.
#[inline(always)]
pub(super) fn outward<S: Isa>(simd: S, half: Vec3, p: &Vec3x<S>) -> (Vec3x<S>, F<S>) {
    let out = from_core(simd, half, p);
    (out, out.dot(out).sqrt() * (1.0 / half.x))
}

#[inline(always)]
fn from_core<S: Isa>(simd: S, half: Vec3, p: &Vec3x<S>) -> Vec3x<S> {
    Vec3x { y: p.y - nearest(simd, half, p.y), ..*p }
}
