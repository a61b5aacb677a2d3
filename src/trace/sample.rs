//! What is kept of a traced point.

use super::batch::{STEP_BITS, Sum};
use crate::lanes::*;

/// A traced point's colour: blue, green and red from the low bits up, 16 bits each, in 128ths of an output step.
#[derive(Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Sample(pub u64);

/// Bits below the point of a sample.
const SAMPLE_BITS: i32 = 7;

/// Parts that a sample counts an output step in.
pub(crate) const STEP: i32 = 1 << SAMPLE_BITS;

/// The colour of a [`Sample`], without what else its word holds.
const COLOUR: u64 = 0xffff_ffff_ffff;

impl Sample {
    /// The colour half-way between two.
    #[inline(always)]
    pub fn mean(self, other: Self) -> Self {
        // Channels are below 2^15, so that no sum reaches the next one.
        Self(((self.0 + other.0) >> 1) & (COLOUR ^ 0x8000_8000_8000))
    }

    /// The colour as a pixel, `0x00RRGGBB`, rounded.
    #[inline(always)]
    pub fn pixel(self) -> u32 {
        // Half a step is added to each channel; none of them overflows.
        let half = (self.0 + 0x0040_0040_0040) >> SAMPLE_BITS;
        (half & 0xff | (half >> 8) & 0xff00 | (half >> 16) & 0x00ff_0000) as u32
    }
}

/// The samples of as many sums as there are lanes.
///
/// They are cut off, not rounded, so that a pixel made of a sample is the sum rounded once.
#[inline(always)]
pub(super) fn from_sums<S: Isa>(simd: S, sums: &[Sum], samples: &mut [u64]) {
    let halves = halves(
        simd,
        sums,
        Cut {
            add: 0,
            shift: 7,
            most: 255 * STEP,
        },
    );
    let (first, second) = samples.split_at_mut(lanes::<S>() / 2);
    let colour = S::u64s::splat(simd, COLOUR);
    (halves.0.bitcast::<S::u64s>() & colour).store_slice(first);
    (halves.1.bitcast::<S::u64s>() & colour).store_slice(second);
}

/// The pixels of as many sums as there are lanes, rounded.
#[inline(always)]
pub(super) fn pixels_from_sums<S: Isa>(simd: S, sums: &[Sum]) -> U<S> {
    let half = 1 << (STEP_BITS - 1);
    let (first, second) = halves(
        simd,
        sums,
        Cut {
            add: half,
            shift: STEP_BITS as u32,
            most: 255,
        },
    );
    first.narrow(second).bitcast::<U<S>>() & 0x00ff_ffff
}

/// How sums become smaller numbers: `(sum + add) >> shift`, cut to 0 to `most`.
#[derive(Clone, Copy)]
struct Cut {
    add: i32,
    shift: u32,
    most: i32,
}

/// The cut channels of half of the points each.
#[inline(always)]
fn halves<S: Isa>(simd: S, sums: &[Sum], to: Cut) -> (S::u16s, S::u16s) {
    let sums = &sums.as_flattened()[..4 * lanes::<S>()];
    let n = lanes::<S>();
    let a = cut(simd, &sums[..n], to);
    let b = cut(simd, &sums[n..2 * n], to);
    let c = cut(simd, &sums[2 * n..3 * n], to);
    let d = cut(simd, &sums[3 * n..], to);
    (a.narrow(b), c.narrow(d))
}

#[inline(always)]
fn cut<S: Isa>(simd: S, sums: &[i32], to: Cut) -> U<S> {
    let whole = (I::<S>::from_slice(simd, sums) + to.add) >> to.shift;
    whole
        .max(I::<S>::splat(simd, 0))
        .min(I::<S>::splat(simd, to.most))
        .bitcast()
}
