//! The plane: a horizontal rectangle. Coordinates are the scene's, unless they are from its centre.

use super::TexturePoint;
use crate::lanes::*;
use crate::scene::Plane;
use glam::{Vec3A, Vec3Swizzles, Vec4};

/// Returns how far on the inner side of the four planes through the eye and an edge a direction leads.
///
/// A ray d meets the plane at `eye + d h / q`, with q = -d.y or d.y the speed at which it comes nearer, and lies on
/// the inner side of an edge `reach` away along x where `reach q - h d.x >= 0`. Scaled below 1, so
/// that one rounding margin serves all.
pub(crate) fn sides(plane: &Plane, eye: Vec3A, d: Vec3A) -> Vec4 {
    let from = eye - Vec3A::from(plane.centre);
    let reach = Vec4::new(plane.half_x, plane.half_x, plane.half_z, plane.half_z)
        + from.xxzz() * Vec4::new(-1.0, 1.0, -1.0, 1.0);
    let h = from.y.abs();
    let scale = 1.0 / (reach.element_sum() + from.abs().element_sum());
    let across = d.xxzz() * Vec4::new(-h, h, -h, h);
    let q = if from.y < 0.0 { d.y } else { -d.y };
    (reach * q + across) * scale
}

/// Which rays hit a plane nearer than `limit`, and where.
#[inline(always)]
pub(crate) fn hit<S: Isa>(
    simd: S,
    plane: &Plane,
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

/// The distances at which lines meet the height of a plane. `from` is their origin, from its centre.
#[inline(always)]
pub(crate) fn distance<S: Isa>(from: &Vec3x<S>, d: &Vec3x<S>) -> F<S> {
    -from.y / d.y
}

/// Where textures are evaluated at points on a plane, `out` from its centre. Their height is set to 0.
#[inline(always)]
pub(crate) fn texture_point<S: Isa>(simd: S, out: Vec3x<S>) -> TexturePoint<S> {
    TexturePoint {
        own: out * Vec3x::splat(simd, Vec3A::new(1.0, 0.0, 1.0)),
        n: Vec3x::splat(simd, Vec3A::Y),
    }
}
