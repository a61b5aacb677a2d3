pub(crate) use fearless_simd::prelude::*;

pub(crate) const MAX_LANES: usize = 16;

pub(crate) type F<S> = <S as Simd>::f32s;
pub(crate) type U<S> = <S as Simd>::u32s;
pub(crate) type I<S> = <S as Simd>::i32s;
pub(crate) type M<S> = <S as Simd>::mask32s;

#[inline(always)]
pub(crate) const fn lanes<S: Simd>() -> usize {
    F::<S>::LEN
}

#[inline(always)]
pub(crate) fn splat<S: Simd>(simd: S, v: f32) -> F<S> {
    F::<S>::splat(simd, v)
}

#[inline(always)]
pub(crate) fn first_lanes<S: Simd>(simd: S, count: usize) -> M<S> {
    M::<S>::from_bitmask(simd, (1 << count) - 1)
}

#[inline(always)]
pub(crate) fn flipped<S: Simd>(c: F<S>, flip: U<S>) -> F<S> {
    (c.bitcast::<U<S>>() ^ flip).bitcast()
}

/// 1.5 * 2^23. Adding it to a number between -2^22 and 2^22 rounds to the nearest integer, in the
/// low bits of the sum; subtracting it again gives a float.
pub const ROUND_TO_INTEGER: f32 = 12_582_912.0;

/// For numbers between -2^22 and 2^22.
#[inline(always)]
pub(crate) fn off_integer<S: Simd>(v: F<S>) -> F<S> {
    v - (v + ROUND_TO_INTEGER - ROUND_TO_INTEGER)
}

#[inline(always)]
pub(crate) fn smooth_step<S: Simd>(v: F<S>) -> F<S> {
    v * v * (v * -2.0 + 3.0)
}

#[inline(always)]
pub(crate) fn lane_numbers<S: Simd>(simd: S) -> U<S> {
    const NUMBERS: [u32; 16] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15];
    U::<S>::from_slice(simd, &NUMBERS[..lanes::<S>()])
}
