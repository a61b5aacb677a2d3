//! Rays side by side: the lane types every kernel is written in.
//!
//! A kernel is generic over the instruction set `S` and inlined into one function per set, so that it is written once:
//! four lanes for SSE2, eight for AVX2, sixteen for AVX-512. A lane's answer never depends on what its neighbours hold.
//!
//! Closures that the compiler does not inline lose the instruction set, and with it their speed: kernels use small
//! functions marked `#[inline(always)]` instead.

mod isa;
mod pow;
mod vec3x;

/// Evaluates an expression by the instruction set of a level, with all that it has: AVX2, or the one that every CPU has.
///
/// Where there is AVX-512 it is AVX2 all the same, except for rays, see [`trace_wide`](crate::trace::trace_wide): squares are judged and
/// filled by rows of eight pixels, which are one of its registers, and wider ones take 1,335 packed bytes of the intro for nothing.
macro_rules! by_isa {
    ($isa:expr, $simd:ident => $expression:expr) => {
        match crate::lanes::avx2($isa) {
            Some($simd) => crate::lanes::by_isa!($simd: $expression),
            None => {
                let $simd = crate::lanes::baseline();
                crate::lanes::by_isa!($simd: $expression)
            }
        }
    };
    ($simd:ident: $expression:expr) => {
        fearless_simd::Simd::vectorize(
            $simd,
            #[inline(always)]
            || $expression,
        )
    };
}

pub(crate) use by_isa;
pub(crate) use fearless_simd::prelude::*;
#[cfg(test)]
pub(crate) use isa::isas;
pub(crate) use isa::{Baseline, Isa, avx2, avx512, baseline};
pub(crate) use pow::{log2, pow};
pub(crate) use vec3x::Vec3x;

/// The most rays that travel together: what a register of the widest instruction set holds.
pub(crate) const MAX_LANES: usize = 16;

/// A number per lane.
pub(crate) type F<S> = <S as Simd>::f32s;
/// An integer or a bit pattern per lane.
pub(crate) type U<S> = <S as Simd>::u32s;
/// A signed integer per lane.
pub(crate) type I<S> = <S as Simd>::i32s;
/// A truth value per lane.
pub(crate) type M<S> = <S as Simd>::mask32s;

/// Rays that travel together.
#[inline(always)]
pub(crate) const fn lanes<S: Simd>() -> usize {
    F::<S>::LEN
}

/// The same number in every lane.
#[inline(always)]
pub(crate) fn splat<S: Simd>(simd: S, v: f32) -> F<S> {
    F::<S>::splat(simd, v)
}

/// The first `count` lanes.
#[inline(always)]
pub(crate) fn first<S: Simd>(simd: S, count: usize) -> M<S> {
    M::<S>::from_bitmask(simd, (1 << count) - 1)
}

/// A number with those bits changed that are in `flip`.
#[inline(always)]
pub(crate) fn flipped<S: Simd>(c: F<S>, flip: U<S>) -> F<S> {
    (c.bitcast::<U<S>>() ^ flip).bitcast()
}

/// The greater number of each lane; `least` where `v` is not a number, on every instruction set. (That of `max` is whichever
/// suits the processor.)
#[inline(always)]
pub(crate) fn at_least<S: Isa>(v: F<S>, least: F<S>) -> F<S> {
    if S::LIMITS_REPLACE_NAN {
        v.max(least)
    } else {
        v.simd_gt(least).select(v, least)
    }
}

/// The lesser number of each lane; `most` where `v` is not a number.
#[inline(always)]
pub(crate) fn at_most<S: Isa>(v: F<S>, most: F<S>) -> F<S> {
    if S::LIMITS_REPLACE_NAN {
        v.min(most)
    } else {
        v.simd_lt(most).select(v, most)
    }
}

/// The numbers from `least` to `most`; `least` where `v` is not a number.
#[inline(always)]
pub(crate) fn clamp<S: Isa>(v: F<S>, least: F<S>, most: F<S>) -> F<S> {
    at_most::<S>(at_least::<S>(v, least), most)
}

/// 1.5 * 2^23. Adding it to a number between -2^22 and 2^22 rounds that to the nearest integer, which then is in the low bits of
/// the sum. Subtracting it again gives the integer as a float.
pub const ROUND_TO_INTEGER: f32 = 12_582_912.0;

/// The numbers less the nearest integers, for numbers between -2^22 and 2^22.
#[inline(always)]
pub(crate) fn off_integer<S: Simd>(v: F<S>) -> F<S> {
    v - (v + ROUND_TO_INTEGER - ROUND_TO_INTEGER)
}

/// Hermite's smooth step from 0 to 1: `v^2 (3 - 2 v)`, with slope 0 at both ends.
#[inline(always)]
pub(crate) fn smooth_step<S: Simd>(v: F<S>) -> F<S> {
    v * v * (v * -2.0 + 3.0)
}

/// The lanes' numbers, from 0.
#[inline(always)]
pub(crate) fn numbers<S: Simd>(simd: S) -> U<S> {
    const NUMBERS: [u32; 16] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15];
    U::<S>::from_slice(simd, &NUMBERS[..lanes::<S>()])
}
