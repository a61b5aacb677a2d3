//! The common ground of the shapes of a block, box, cylinder and capsule: the coordinates along its own axes, in which each answers
//! for itself.
//! Other coordinates are the scene's.

use super::sphere::Chord;
use super::{TexturePoint, capsule, cuboid, cylinder};
use crate::lanes::*;
use crate::rounding;
use crate::scene::{Block, Shape};
use glam::{Mat3, Vec3A};

/// Added to directions along a block's axes, to avoid divisions by 0 for rays that are parallel to a side.
const TINY: f32 = 1e-12;

/// A vector's components along three axes.
#[inline(always)]
fn along<S: Isa>(simd: S, axes: &Mat3, v: &Vec3x<S>) -> Vec3x<S> {
    Vec3x {
        x: v.dot(Vec3x::splat(simd, axes.x_axis)),
        y: v.dot(Vec3x::splat(simd, axes.y_axis)),
        z: v.dot(Vec3x::splat(simd, axes.z_axis)),
    }
}

/// Returns the distances at which rays first hit a block, infinite for rays that miss it, and which rays come from within.
///
/// Rays of the mask `inward` start on its surface and go into it: they meet its far side, whatever rounding makes of their origin.
#[inline(always)]
pub(crate) fn distance<S: Isa>(
    simd: S,
    block: &Block,
    o: &Vec3x<S>,
    d: &Vec3x<S>,
    inward: M<S>,
) -> (F<S>, M<S>) {
    let tiny = Vec3x::splat(simd, Vec3A::splat(TINY));
    let o = along(simd, &block.axes, &(*o - Vec3x::splat(simd, block.centre)));
    let d = along(simd, &block.axes, d) + tiny;
    let span = match block.shape {
        Shape::Box => cuboid::span(simd, block.half, &o, &d),
        Shape::Cylinder => cylinder::span(simd, block.half, &o, &d),
        Shape::Capsule => capsule::span(simd, block.half, &o, &d, inward),
    };
    let zero = splat(simd, 0.0);
    let is_inside = inward | span.near.simd_le(zero);
    let t = is_inside.select(span.far, span.near);
    let is_met = span.is_met & span.near.simd_le(span.far) & t.simd_gt(zero);
    let t = at_least::<S>(t, splat(simd, f32::MIN_POSITIVE));
    let t = (is_met | inward).select(t, splat(simd, f32::INFINITY));
    (t, is_inside)
}

/// The parts of points, in a block's own coordinates, along the axes towards the faces they are on, and how far out they are towards
/// these, if faces are at 1. `out` has how far out points are along each axis, if faces are at -1 and 1.
#[inline(always)]
fn outermost<S: Isa>(simd: S, own: &Vec3x<S>, out: Vec3x<S>) -> (Vec3x<S>, F<S>) {
    let farthest = out.max_element();
    let zero = splat(simd, 0.0);
    let face = Vec3x {
        x: out.x.simd_ge(farthest).select(own.x, zero),
        y: out.y.simd_ge(farthest).select(own.y, zero),
        z: out.z.simd_ge(farthest).select(own.z, zero),
    };
    (face, farthest)
}

/// Points on the surface of a block, one per ray.
pub(crate) struct BlockHit<S: Isa> {
    /// From the centre, in scene coordinates.
    pub out: Vec3x<S>,
    /// Where textures are evaluated, and the normal, outward.
    pub texture_point: TexturePoint<S>,
}

impl<S: Isa> BlockHit<S> {
    /// Projects points that rounding has taken off the surface, `out` from the centre, to the nearest face.
    #[inline(always)]
    pub fn near(simd: S, block: &Block, out: Vec3x<S>) -> Self {
        let own = along(simd, &block.axes, &out);
        let parts = own * Vec3x::splat(simd, block.half.recip());
        let (face, farthest) = match block.shape {
            Shape::Box => outermost(simd, &own, cuboid::outward(parts)),
            Shape::Cylinder => outermost(simd, &own, cylinder::outward(parts)),
            Shape::Capsule => capsule::outward(simd, block.half, &own),
        };
        let length = face.dot(face).sqrt();
        let inverse = splat::<S>(simd, 1.0) / length;
        let n = along(simd, &block.axes.transpose(), &face.scaled(inverse));
        Self {
            out: out.add_scaled(n, length / farthest - length),
            texture_point: TexturePoint { own, n },
        }
    }
}

/// The offset from the surface at which secondary rays of a block start, in scene units: many times the rounding error of a point
/// on it. At ten units from the origin it is 1e-4.
pub(crate) fn hit_error(block: &Block) -> f32 {
    rounding::BLOCK_HIT * (Vec3A::from(block.centre).abs() + Vec3A::from(block.half)).element_sum()
}

/// The radius of its bounding sphere, enlarged to cover rounding.
pub(crate) fn bounding_radius(block: &Block) -> f32 {
    Vec3A::from(block.half).length() * (1.0 + rounding::BLOCK_BOUND)
}

/// The longer of its own y and z axes, along which long blocks extend, if they stand or if they lie; and the squared radius of the
/// cylinder around that which contains it.
pub(crate) fn bounding_cylinder(block: &Block) -> (Vec3A, f32) {
    let half2 = block.half * block.half;
    if half2.y < half2.z {
        (block.axes.z_axis.into(), half2.x + half2.y)
    } else {
        let radius2 = match block.shape {
            Shape::Box => half2.x + half2.z,
            Shape::Cylinder | Shape::Capsule => half2.x,
        };
        (block.axes.y_axis.into(), radius2)
    }
}

/// Which rays along `d` certainly miss a block, or hit it beyond `limit`: they pass its [`bounding_cylinder`], or end before its
/// bounding sphere of a radius, whose chord is given.
#[inline(always)]
pub(crate) fn is_off<S: Isa>(
    chord: &Chord<S>,
    d: Vec3x<S>,
    (axis, radius2): (Vec3A, f32),
    radius: f32,
    limit: F<S>,
) -> M<S> {
    let simd = chord.t_mid.token();
    let axis = Vec3x::splat(simd, axis);
    let (along, across) = (d.dot(axis), chord.l.dot(axis));
    // The squared sine of the angle between ray and axis, reduced by the rounding error. Squared distances are compared after
    // multiplication with it.
    let sine2 = splat::<S>(simd, 1.0 - rounding::COSINE2) - along * along;
    let beyond = chord.l2 - radius2;
    let is_off = (beyond * at_least::<S>(sine2, splat(simd, 0.0))).simd_gt(across * across);
    is_off | chord.t_mid.simd_gt(limit + radius)
}
