use super::TexturePoint;
use crate::lanes::*;
use crate::scene::Plane;
use glam::{Vec3A, Vec3Swizzles, Vec4};

/// Returns the distance of a direction inside each of the four planes through the eye and an edge.
///
/// From the height h, a ray d meets the plane at `eye + d h / q`, where q is its rate of approach,
/// -d.y or d.y. It is inside an edge at the distance `reach` along x if `reach q - h d.x >= 0`.
/// Results are below 1, so that one rounding margin fits all.
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

#[inline(always)]
pub(crate) fn hit<S: Isa>(
    simd: S,
    plane: &Plane,
    o: Vec3x<S>,
    d: Vec3x<S>,
    limit: F<S>,
) -> (M<S>, F<S>) {
    let [x, y, z] = plane.centre.to_array();
    // Infinite or NaN for rays parallel to the plane: the comparisons below fail.
    let t = (splat(simd, y) - o.y) / d.y;
    let across = t.mul_add(d.x, o.x - x).abs();
    let along = t.mul_add(d.z, o.z - z).abs();
    // Rays that start on the plane have t = 0: their height is exact.
    let hit = t.simd_gt(splat(simd, 0.0))
        & t.simd_lt(limit)
        & across.simd_le(splat(simd, plane.half_x))
        & along.simd_le(splat(simd, plane.half_z));
    (hit, t)
}

/// Returns the distances at which lines from `from`, relative to the centre, meet the height of a
/// plane.
#[inline(always)]
pub(crate) fn distance<S: Isa>(from: &Vec3x<S>, d: &Vec3x<S>) -> F<S> {
    -from.y / d.y
}

/// Returns the texture points of hits, `out` relative to the centre, at height 0.
#[inline(always)]
pub(crate) fn texture_point<S: Isa>(simd: S, out: Vec3x<S>) -> TexturePoint<S> {
    TexturePoint {
        own: out * Vec3x::splat(simd, Vec3A::new(1.0, 0.0, 1.0)),
        n: Vec3x::splat(simd, Vec3A::Y),
    }
}
