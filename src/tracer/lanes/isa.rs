//! Operations that differ between instruction sets.

use super::types::*;
use fearless_simd::Level;

pub(crate) trait Isa: Simd {
    /// Whether [`SimdFloat::mul_add`] rounds once.
    const FUSES_MUL_ADD: bool;
    /// Whether 32-bit integers are multiplied by one instruction.
    const MULTIPLIES_INTEGERS: bool = true;
    /// Whether [`SimdFloat::max`] and [`SimdFloat::min`] return their second operand if the first
    /// is NaN.
    const LIMITS_REPLACE_NAN: bool = cfg!(any(target_arch = "x86", target_arch = "x86_64"));

    fn of(level: Level) -> Option<Self>;

    /// Moves the lanes in `mask` to the first places, in order. The default is small, but slow.
    #[inline(always)]
    fn gather_first<const N: usize>(self, rows: &mut [F<Self>; N], mask: M<Self>) {
        let mut rest = mask.to_bitmask();
        let mut place = 0;
        while rest != 0 {
            let lane = rest.trailing_zeros() as usize % lanes::<Self>();
            for row in rows.iter_mut() {
                let row = row.as_mut_slice();
                row[place % lanes::<Self>()] = row[lane];
            }
            place += 1;
            rest &= rest - 1;
        }
    }
}

/// Replaces NaN. (The result of `max` depends on the CPU.)
#[inline(always)]
pub(crate) fn at_least<S: Isa>(v: F<S>, min: F<S>) -> F<S> {
    if S::LIMITS_REPLACE_NAN { v.max(min) } else { v.simd_gt(min).select(v, min) }
}

/// Replaces NaN.
#[inline(always)]
pub(crate) fn at_most<S: Isa>(v: F<S>, max: F<S>) -> F<S> {
    if S::LIMITS_REPLACE_NAN { v.min(max) } else { v.simd_lt(max).select(v, max) }
}

/// NaN becomes `min`.
#[inline(always)]
pub(crate) fn clamp<S: Isa>(v: F<S>, min: F<S>, max: F<S>) -> F<S> {
    at_most::<S>(at_least::<S>(v, min), max)
}

cfg_select! {
    all(any(target_arch = "x86", target_arch = "x86_64"), target_feature = "sse2", target_feature = "fxsr") => {
        pub(crate) type Baseline = fearless_simd::Sse2;

        #[inline(always)]
        fn baseline_of(level: Level) -> Option<Baseline> {
            level.as_sse2()
        }
    }
    all(target_arch = "aarch64", target_feature = "neon") => {
        pub(crate) type Baseline = fearless_simd::Neon;

        #[inline(always)]
        fn baseline_of(level: Level) -> Option<Baseline> {
            level.as_neon()
        }
    }
    all(target_arch = "wasm32", target_feature = "simd128") => {
        pub(crate) type Baseline = fearless_simd::WasmSimd128;

        #[inline(always)]
        fn baseline_of(level: Level) -> Option<Baseline> {
            level.as_wasm_simd128()
        }
    }
    _ => {
        pub(crate) type Baseline = fearless_simd::Fallback;

        #[inline(always)]
        fn baseline_of(_: Level) -> Option<Baseline> {
            Some(Baseline::new())
        }
    }
}

#[inline(always)]
pub(crate) fn baseline() -> Baseline {
    baseline_of(Level::baseline()).expect("the baseline level has its instruction set")
}

#[cfg(test)]
pub(crate) fn isas() -> impl Iterator<Item = Level> {
    let best = Level::new();
    #[cfg(target_arch = "x86_64")]
    let all = [
        best.as_sse2().map(Level::Sse2),
        best.as_avx2().map(Level::Avx2),
        best.as_avx512().map(Level::Avx512),
    ];
    #[cfg(not(target_arch = "x86_64"))]
    let all = [Some(best)];
    all.into_iter().flatten()
}

impl Isa for Baseline {
    const FUSES_MUL_ADD: bool = cfg!(target_arch = "aarch64");
    // SSE2 has only full products.
    const MULTIPLIES_INTEGERS: bool = cfg!(not(any(target_arch = "x86", target_arch = "x86_64")));

    #[inline(always)]
    fn of(level: Level) -> Option<Self> {
        baseline_of(level)
    }
}

#[cfg(target_arch = "x86_64")]
mod x86_64 {
    use super::*;
    use core::arch::x86_64::*;
    use fearless_simd::{Avx2, f32x8, kernel};

    impl Isa for Avx2 {
        const FUSES_MUL_ADD: bool = true;

        #[inline(always)]
        fn of(level: Level) -> Option<Self> {
            level.as_avx2()
        }

        #[inline(always)]
        fn gather_first<const N: usize>(self, rows: &mut [F<Self>; N], mask: M<Self>) {
            let order = order(self, mask.to_bitmask());
            for row in rows {
                *row = permute(self, *row, order);
            }
        }
    }

    kernel!(
        /// Returns the indices of a mask's lanes, in order, without a table. (Slow microcode on AMD
        /// before Zen 3.)
        #[inline(always)]
        fn order(simd: Avx2, mask: u64) -> __m256i {
            let bytes = _pdep_u64(mask, 0x0101_0101_0101_0101) * 0xff;
            let lanes = _pext_u64(0x0706_0504_0302_0100, bytes);
            _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(lanes as i64))
        }
    );

    kernel!(
        #[inline(always)]
        fn permute(simd: Avx2, row: f32x8<Avx2>, order: __m256i) -> f32x8<Avx2> {
            _mm256_permutevar8x32_ps(row.into(), order).simd_into(simd)
        }
    );

    impl Isa for fearless_simd::Avx512 {
        const FUSES_MUL_ADD: bool = true;

        #[inline(always)]
        fn of(level: Level) -> Option<Self> {
            level.as_avx512()
        }

        #[inline(always)]
        fn gather_first<const N: usize>(self, rows: &mut [F<Self>; N], mask: M<Self>) {
            for row in rows {
                *row = row.compress(mask);
            }
        }
    }
}
