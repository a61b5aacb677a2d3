use super::fill::{self, Run};
use super::verdict::{self, Limit, Verdict};
use crate::grid::{Bits, GridRow};
use crate::lanes::{Baseline, Isa, by_isa};
use crate::maths::to_f32;
use crate::picture::Band;
use crate::prepare::{VisibleGroups, World};
use crate::quality::Quality;
use crate::trace::{self, Batch, PatternOnScreen, Tracer};
use fearless_simd::Level;
#[cfg(target_arch = "x86_64")]
use fearless_simd::{Avx2, Avx512};

/// The functions that are compiled for each instruction set. Programs that only use AVX2 kernels
/// link only these.
#[derive(Clone, Copy)]
pub(crate) struct Kernels {
    pub level: Level,
    pub trace: fn(Level, World<'_>, &Quality, VisibleGroups, &mut Batch),
    pub(super) judge: fn(Level, [Limit; 2], &Bits, GridRow<'_>, GridRow<'_>) -> Verdict,
    pub(super) fill: fn(Level, &mut Band<'_>, &Run<'_>),
    /// See [`PatternOnScreen::set_shares`].
    pub(super) pattern: fn(Level, &PatternOnScreen<'_>, [usize; 2], usize, &mut [f32; 64]),
}

impl Kernels {
    /// AVX-512 is only for rays: eight pixels, the row of a square, fit an AVX2 register.
    pub fn widest(level: Level) -> Self {
        #[cfg(target_arch = "x86_64")]
        if level.as_avx512().is_some() {
            return Self::of::<Avx512, Avx2>(level);
        }
        Self::narrow(level)
    }

    pub fn narrow(level: Level) -> Self {
        #[cfg(target_arch = "x86_64")]
        if let Some(simd) = level.as_avx2() {
            return Self::avx2(simd);
        }
        Self::of::<Baseline, Baseline>(level)
    }

    // Not in the caller's crate, which may be optimised for size.
    #[cfg(target_arch = "x86_64")]
    #[inline(never)]
    pub fn avx2(simd: Avx2) -> Self {
        Self::of::<Avx2, Avx2>(Level::Avx2(simd))
    }

    /// Rays use `R`, squares use `S`; `level` has both.
    fn of<R: Isa, S: Isa>(level: Level) -> Self {
        Self {
            level,
            trace: |level, world, quality, visible, batch| {
                let isa = in_level::<R>(level);
                by_isa!(isa: trace::trace(Tracer { isa, world, quality }, visible, batch));
            },
            judge: |level, limits, squares, above, below| {
                verdict::judge(in_level::<S>(level), limits, squares, above, below)
            },
            fill: |level, band, run| fill::fill(in_level::<S>(level), band, run),
            pattern: |level, pattern, start, side, shares| {
                let simd = in_level::<S>(level);
                by_isa!(simd: pattern.set_shares(simd, start.map(to_f32), side, shares));
            },
        }
    }
}

#[inline(always)]
fn in_level<S: Isa>(level: Level) -> S {
    // `expect` would add 900 packed bytes for its message.
    S::of(level).unwrap()
}
