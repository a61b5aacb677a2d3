//! Eight rays side by side: the lane types every kernel is written in.
//!
//! A kernel is generic over the instruction set `S` and inlined into one function per set, so that it is written
//! once. A lane's answer never depends on what its neighbours hold.

mod pow;
mod vec3x;

pub(crate) use fearless_simd::prelude::*;
use fearless_simd::{f32x16, i32x16, mask32x16, u32x16};
pub(crate) use pow::pow;
pub(crate) use vec3x::Vec3x;

/// Rays that travel together: what one AVX2 register holds.
pub(crate) const LANES: usize = 16;

/// A number per lane.
pub(crate) type F<S> = f32x16<S>;
/// An integer or a bit pattern per lane.
pub(crate) type U<S> = u32x16<S>;
/// A signed integer per lane.
pub(crate) type I<S> = i32x16<S>;
/// A truth value per lane.
pub(crate) type M<S> = mask32x16<S>;

/// `a b + c` in every lane, rounded once where the instruction set has FMA.
#[inline(always)]
pub(crate) fn fma<S: Simd>(a: F<S>, b: F<S>, c: F<S>) -> F<S> {
    a.mul_add(b, c)
}

/// The same number in every lane.
#[inline(always)]
pub(crate) fn splat<S: Simd>(simd: S, v: f32) -> F<S> {
    F::splat(simd, v)
}

/// The first `count` lanes.
#[inline(always)]
pub(crate) fn first<S: Simd>(simd: S, count: usize) -> M<S> {
    M::from_bitmask(simd, (1 << count) - 1)
}
