use crate::lanes::*;
use glam::Vec3;

pub(super) struct Span<S: Isa> {
    /// Above `far` for some rays that miss.
    pub near: F<S>,
    pub far: F<S>,
    pub is_met: M<S>,
}

impl<S: Isa> Span<S> {
    /// Returns the intervals within `half` of the centre along one axis. `o` and `d` are the rays'
    /// components along it.
    #[inline(always)]
    pub fn slab(simd: S, o: F<S>, d: F<S>, half: f32) -> Self {
        let middle = -o / d;
        let half = (splat(simd, half) / d).abs();
        Self { near: middle - half, far: middle + half, is_met: M::<S>::splat(simd, true) }
    }

    #[inline(always)]
    pub fn and(self, other: Self) -> Self {
        Self {
            near: at_least::<S>(self.near, other.near),
            far: at_most::<S>(self.far, other.far),
            is_met: self.is_met & other.is_met,
        }
    }
}

/// Kay and Kajiya: Ray Tracing Complex Scenes, SIGGRAPH 1986.
#[inline(always)]
pub(super) fn span<S: Isa>(simd: S, half: Vec3, o: &Vec3x<S>, d: &Vec3x<S>) -> Span<S> {
    let upright = Span::slab(simd, o.y, d.y, half.y);
    upright.and(Span::slab(simd, o.x, d.x, half.x)).and(Span::slab(simd, o.z, d.z, half.z))
}

/// Returns the distance of points along each axis, where the faces are at -1 and 1.
#[inline(always)]
pub(super) fn outward<S: Isa>(p: Vec3x<S>) -> Vec3x<S> {
    Vec3x { x: p.x.abs(), y: p.y.abs(), z: p.z.abs() }
}
