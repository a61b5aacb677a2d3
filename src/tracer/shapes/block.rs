use super::sphere::Chord;
use super::{TexturePoint, capsule, cuboid, cylinder};
use crate::lanes::*;
use crate::rounding;
use crate::scene::{Block, Shape};
use glam::{Mat3, Mat3A, Vec3A};

/// Added to directions along a block's axes, against divisions by 0.
pub(super) const TINY: f32 = 1e-12;

#[inline(always)]
pub(crate) fn along<S: Isa>(simd: S, axes: &Mat3, v: &Vec3x<S>) -> Vec3x<S> {
    Vec3x {
        x: v.dot(Vec3x::splat(simd, axes.x_axis)),
        y: v.dot(Vec3x::splat(simd, axes.y_axis)),
        z: v.dot(Vec3x::splat(simd, axes.z_axis)),
    }
}

/// Returns the distances of hits, infinite for misses, and the mask of rays that start inside.
///
/// Rays of the mask `inward` start on the surface and hit the far side, whatever the rounding of
/// their origin.
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

/// Returns the components of `own` along the axes of each point's face, and the point's distance
/// relative to the face's. `out` has the relative distance along each axis.
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

pub(crate) struct BlockHit<S: Isa> {
    pub out: Vec3x<S>,
    pub texture_point: TexturePoint<S>,
}

impl<S: Isa> BlockHit<S> {
    /// Projects points near the surface onto the nearest face.
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

/// See [`rounding::BLOCK_HIT`]. Lights and objects that an eye sees near a huge block must not be
/// below its points.
pub(crate) fn hit_error(block: &Block, eye: Vec3A) -> f32 {
    let reach = Vec3A::from(block.centre).abs() + Vec3A::from(block.half);
    let error = rounding::BLOCK_HIT * reach.element_sum();
    if above(block, eye).abs() < rounding::AT_EYE * error {
        rounding::MIN_BLOCK_HIT * reach.element_sum()
    } else {
        error
    }
}

/// Returns the distance from the nearest side, negative inside, at most as far as from an edge.
fn above(block: &Block, point: Vec3A) -> f32 {
    let own = Mat3A::from(block.axes).transpose() * (point - Vec3A::from(block.centre));
    let half = Vec3A::from(block.half);
    let flat = own.abs() - half;
    if block.shape == Shape::Box {
        return flat.max_element();
    }
    let core = match block.shape {
        Shape::Capsule => half.y - half.x,
        _ => f32::INFINITY,
    };
    let out = own - Vec3A::Y * own.y.min(core).max(-core);
    flat.y.max(out.length() - half.x)
}

pub(crate) fn bounding_radius(block: &Block) -> f32 {
    Vec3A::from(block.half).length() * (1.0 + rounding::BLOCK_BOUND)
}

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

/// Returns the rays along `d` that certainly miss a block's [`bounding_cylinder`], or hit beyond
/// `limit`. `radius` and `chord` belong to the bounding sphere.
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
    // The squared sine of the angle between ray and axis, reduced by the rounding error.
    let sine2 = splat::<S>(simd, 1.0 - rounding::COSINE2) - along * along;
    let beyond = chord.l2 - radius2;
    let is_off = (beyond * at_least::<S>(sine2, splat(simd, 0.0))).simd_gt(across * across);
    is_off | chord.t_mid.simd_gt(limit + radius)
}
