//! The box, in a block's own coordinates: from its centre, along its own axes.

use crate::lanes::*;
use glam::Vec3;

/// The parts of rays' lines inside of something convex.
pub(super) struct Span<S: Isa> {
    /// The distance at which a ray enters, and that at which it leaves. What a ray misses it leaves before it enters, or else
    /// `is_met` is false.
    pub near: F<S>,
    pub far: F<S>,
    pub is_met: M<S>,
}

impl<S: Isa> Span<S> {
    /// Inside of the slab within `half` of the centre along one axis. `o` and `d` are the rays' origins and directions along that
    /// axis.
    #[inline(always)]
    pub fn slab(simd: S, o: F<S>, d: F<S>, half: f32) -> Self {
        let middle = -o / d;
        let half = (splat(simd, half) / d).abs();
        Self {
            near: middle - half,
            far: middle + half,
            is_met: M::<S>::splat(simd, true),
        }
    }

    /// Inside of both this and another.
    #[inline(always)]
    pub fn and(self, other: Self) -> Self {
        Self {
            near: at_least::<S>(self.near, other.near),
            far: at_most::<S>(self.far, other.far),
            is_met: self.is_met & other.is_met,
        }
    }
}

/// The parts of lines inside.
///
/// A ray is inside of the box while it is inside of all slabs (Kay and Kajiya: Ray Tracing Complex Scenes, SIGGRAPH 1986).
#[inline(always)]
pub(super) fn span<S: Isa>(simd: S, half: Vec3, o: &Vec3x<S>, d: &Vec3x<S>) -> Span<S> {
    let upright = Span::slab(simd, o.y, d.y, half.y);
    upright
        .and(Span::slab(simd, o.x, d.x, half.x))
        .and(Span::slab(simd, o.z, d.z, half.z))
}

/// How far out points are towards the faces along each axis, if these are at -1 and 1: the farthest is the face they are on.
#[inline(always)]
pub(super) fn outward<S: Isa>(p: Vec3x<S>) -> Vec3x<S> {
    Vec3x {
        x: p.x.abs(),
        y: p.y.abs(),
        z: p.z.abs(),
    }
}
