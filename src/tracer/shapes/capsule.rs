//! The capsule, a cylinder with a half sphere at each end, in a block's own coordinates: from its centre, along its own axes. It
//! stands along y.
//!
//! It is all that is within the radius of its core: the part of the axis between the centres of both ends.

use super::cuboid::Span;
use super::cylinder;
use crate::lanes::*;
use glam::Vec3;

/// The ends of the parts of lines inside: both are where rays enter; or 0, and where they leave, if they start inside, as rays of the
/// mask `inward` do.
///
/// There a sphere about the core touches the surface from within: that about the point which is nearest to where the ray crosses the
/// endless cylinder.
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
    let from = Vec3x {
        y: o.y - nearest(simd, half, y),
        ..*o
    };
    let length2 = d.dot(*d);
    let middle = -from.dot(*d) / length2;
    let across = from.add_scaled(*d, middle);
    let half2 = -across.dot(across) + half.x * half.x;
    let chord = (at_least::<S>(half2, zero) / length2).sqrt();
    let t = middle + is_inside.select(chord, -chord);
    // Rounding does not let rays out that start inside.
    Span {
        near: is_inside.select(zero, t),
        far: t,
        is_met: half2.simd_ge(zero) | is_inside,
    }
}

/// The heights of the points of the core that are nearest to points of some heights.
#[inline(always)]
fn nearest<S: Isa>(simd: S, half: Vec3, y: F<S>) -> F<S> {
    let end = half.y - half.x;
    clamp::<S>(y, splat(simd, -end), splat(simd, end))
}

/// The ways from the core to points, and how far out these are, if the surface is at 1.
#[inline(always)]
pub(super) fn outward<S: Isa>(simd: S, half: Vec3, p: &Vec3x<S>) -> (Vec3x<S>, F<S>) {
    let way = from_core(simd, half, p);
    (way, way.dot(way).sqrt() * (1.0 / half.x))
}

/// The ways from the core to points.
#[inline(always)]
fn from_core<S: Isa>(simd: S, half: Vec3, p: &Vec3x<S>) -> Vec3x<S> {
    Vec3x {
        y: p.y - nearest(simd, half, p.y),
        ..*p
    }
}
