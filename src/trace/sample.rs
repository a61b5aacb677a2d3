//! What is kept of a traced point.

use super::batch::{STEP_BITS, Sum};
use crate::lanes::*;
use fearless_simd::u16x32;

/// A traced point's colour: blue, green and red from the low bits up, 16 bits each, in 128ths of an output step.
#[derive(Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Sample(pub u64);

/// Bits below the point of a sample.
const SAMPLE_BITS: i32 = 7;

/// Parts that a sample counts an output step in.
pub(crate) const STEP: i32 = 1 << SAMPLE_BITS;

impl Sample {
    /// Blue, green and red, in steps.
    #[inline(always)]
    pub fn channel(self, i: usize) -> f32 {
        (self.0 >> (16 * i)) as u16 as f32 * (1.0 / STEP as f32)
    }

    /// The colour as a pixel, `0x00RRGGBB`, rounded.
    #[inline(always)]
    pub fn pixel(self) -> u32 {
        // Half a step is added to each channel; none of them overflows.
        let half = (self.0 + 0x0040_0040_0040) >> SAMPLE_BITS;
        (half & 0xff | (half >> 8) & 0xff00 | (half >> 16) & 0x00ff_0000) as u32
    }
}

/// The samples of a packet's sums.
///
/// They are cut off, not rounded, so that a pixel made of a sample is the sum rounded once.
#[inline(always)]
pub(super) fn from_sums<S: Simd>(simd: S, sums: &[Sum; LANES], samples: &mut [Sample; LANES]) {
    let [first, second] = halves(simd, sums, 0, STEP_BITS - SAMPLE_BITS, 255 * STEP);
    let first = first.to_array();
    let second = second.to_array();
    let channels = first
        .as_chunks::<4>()
        .0
        .iter()
        .chain(second.as_chunks::<4>().0);
    for (sample, &[b, g, r, _]) in samples.iter_mut().zip(channels) {
        *sample = Sample(u64::from(b) | u64::from(g) << 16 | u64::from(r) << 32);
    }
}

/// The pixels of a packet's sums, rounded.
#[inline(always)]
pub(super) fn pixels_from_sums<S: Simd>(simd: S, sums: &[Sum; LANES]) -> [u32; LANES] {
    let [first, second] = halves(simd, sums, 1 << (STEP_BITS - 1), STEP_BITS, 255);
    let pixels: U<S> = first.narrow(second).bitcast();
    (pixels & 0x00ff_ffff).to_array()
}

/// `(sum + add) >> shift`, cut to 0 to `most`, of the channels of half of the points each.
#[inline(always)]
fn halves<S: Simd>(
    simd: S,
    sums: &[Sum; LANES],
    add: i32,
    shift: i32,
    most: i32,
) -> [u16x32<S>; 2] {
    let (quarters, _) = sums.as_flattened().as_chunks::<LANES>();
    let a = cut(simd, &quarters[0], add, shift, most);
    let b = cut(simd, &quarters[1], add, shift, most);
    let c = cut(simd, &quarters[2], add, shift, most);
    let d = cut(simd, &quarters[3], add, shift, most);
    [a.narrow(b), c.narrow(d)]
}

/// `(sum + add) >> shift`, cut to 0 to `most`.
#[inline(always)]
fn cut<S: Simd>(simd: S, sums: &[i32; LANES], add: i32, shift: i32, most: i32) -> U<S> {
    let whole = (I::load_array_ref(simd, sums) + add) >> shift as u32;
    whole
        .max(I::splat(simd, 0))
        .min(I::splat(simd, most))
        .bitcast()
}
