//! The verdict on squares, by their corners' keys and colours.

use crate::grid::{Bits, GridRow};
use crate::lanes::*;
use crate::quality::Quality;
use crate::trace::{STEP, Sample};

/// The largest allowed difference of channels at a square's corners, in 128ths of an output step:
/// 16 bits per channel, like a [`Sample`], and ones in the bits that are ignored.
#[derive(Clone, Copy)]
pub(super) struct Limit(u64);

impl Limit {
    pub fn new(tolerance: f32) -> Self {
        let limit = tolerance * STEP as f32;
        // 15 bits exceed any difference; NaN becomes 0.
        let limit = limit.clamp(0.0, 32_767.0) as u64;
        Self((limit * 0x0001_0001_0001) | (0xffff << 48))
    }

    /// Returns whether two samples are within the limit, to 1/128 of a step. Halved channels leave
    /// a word's highest bit for the result.
    pub fn has(self, a: Sample, b: Sample) -> bool {
        const HALF: u64 = 0x3fff_3fff_3fff;
        const GREATER: u64 = 0x8000_8000_8000;
        let [a, b, limit] = [a.0 >> 1 & HALF, b.0 >> 1 & HALF, self.0 >> 1 & HALF];
        let is_below = ((a + limit) | GREATER) - b;
        let is_above = ((b + limit) | GREATER) - a;
        is_below & is_above & GREATER == GREATER
    }
}

/// Returns the factor on tolerances for squares of `side` pixels, see [`Quality`]. In crowded tiles
/// (`crowding`, 0 to 1) errors in small squares add up.
pub(super) fn growth(side: usize, crowding: f32) -> f32 {
    let growth = 8.0 / side as f32;
    growth + crowding * (1.0 - growth)
}

pub(super) fn limits(quality: &Quality, growth: f32) -> [Limit; 2] {
    let tolerances = [quality.tolerance_agreeing, quality.tolerance_differing];
    tolerances.map(|tolerance| Limit::new(tolerance * growth))
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Verdict {
    pub agreeing: Bits,
    pub flat: Bits,
    /// The corners show one object, in the same 8-bit colour or within the limit.
    pub filled: Bits,
    /// A corner shows a pattern finer than squares.
    pub patterned: Bits,
}

impl Verdict {
    pub const NONE: Self =
        Self { agreeing: Bits::NONE, flat: Bits::NONE, filled: Bits::NONE, patterned: Bits::NONE };

    pub fn coarse(squares: Bits) -> Self {
        Self { agreeing: squares, flat: squares, filled: squares, ..Self::NONE }
    }
}

#[inline(always)]
pub(super) fn judge<S: Simd>(
    simd: S,
    limits: [Limit; 2],
    squares: &Bits,
    above: GridRow<'_>,
    below: GridRow<'_>,
) -> Verdict {
    by_isa!(simd: judge_by(simd, limits, squares, above, below))
}

#[inline(always)]
fn judge_by<S: Simd>(
    simd: S,
    limits: [Limit; 2],
    squares: &Bits,
    above: GridRow<'_>,
    below: GridRow<'_>,
) -> Verdict {
    let mut verdict = Verdict::NONE;
    let n = lanes::<S>();
    for (word, &squares) in squares.0.iter().enumerate() {
        let mut rest = squares;
        while rest != 0 {
            let first = rest.trailing_zeros() as usize / n * n;
            let group = ((1 << n) - 1) << first;
            rest &= !group;
            let x = 64 * word + first;
            let rows = (&above.keys[x..=x + n], &below.keys[x..=x + n]);
            let [a, b, c, d]: [U<S>; 4] = corners(simd, rows);
            let agreeing = a.simd_eq(b) & a.simd_eq(c) & a.simd_eq(d);
            let agreeing = agreeing.to_bitmask() << first;
            let (mut near, mut flat, mut shared, mut patterned) = ([0; 2], 0, 0, 0);
            for half in [0, n / 2] {
                let samples = x + half..=x + half + n / 2;
                let rows = (&above.samples[samples.clone()], &below.samples[samples]);
                let samples: [S::u64s; 4] = corners(simd, rows);
                // Channels are below 2^15; SSE2 cannot compare unsigned words.
                let [a, b, c, d] = samples.map(Bytes::bitcast::<S::i16s>);
                let (max, min) = (a.max(b).max(c.max(d)), a.min(b).min(c.min(d)));
                let first = first + half;
                for (near, limit) in near.iter_mut().zip(limits) {
                    *near |= within(simd, max, min, limit) << first;
                }
                let [pixels, objects] = same_pixels_and_objects(simd, max, min);
                flat |= pixels << first;
                shared |= objects << first;
                patterned |= any_patterned(simd, samples) << first;
            }
            let [near_agreeing, near_differing] = near;
            let near = near_agreeing & agreeing | near_differing & !agreeing;
            verdict.agreeing.0[word] |= agreeing & squares;
            verdict.flat.0[word] |= flat & squares;
            verdict.filled.0[word] |= (near | flat) & shared & squares;
            verdict.patterned.0[word] |= patterned & squares;
        }
    }
    verdict
}

#[inline(always)]
fn corners<S: Simd, V: SimdBase<S>>(
    simd: S,
    (above, below): (&[V::Element], &[V::Element]),
) -> [V; 4] {
    [above, &above[1..], below, &below[1..]].map(|row| V::from_slice(simd, &row[..V::LEN]))
}

#[inline(always)]
fn any_patterned<S: Simd>(simd: S, [a, b, c, d]: [S::u64s; 4]) -> u64 {
    let pattern = (a | b | c | d) & S::u64s::splat(simd, Sample::PATTERN);
    (!pattern.simd_eq(S::u64s::splat(simd, 0))).to_bitmask()
}

#[inline(always)]
fn within<S: Simd>(simd: S, max: S::i16s, min: S::i16s, limit: Limit) -> u64 {
    let span: S::u16s = (max - min).bitcast();
    let limit: S::u16s = S::u64s::splat(simd, limit.0).bitcast();
    let excess: S::u64s = span.saturating_sub(limit).bitcast();
    excess.simd_eq(S::u64s::splat(simd, 0)).to_bitmask()
}

/// Returns the squares whose corners have one rounded colour, and those whose corners show one
/// object. Rounding is monotonic, so comparing the extremes suffices.
#[inline(always)]
fn same_pixels_and_objects<S: Simd>(simd: S, max: S::i16s, min: S::i16s) -> [u64; 2] {
    let half = S::i16s::splat(simd, STEP as i16 / 2);
    let step = |channel: S::i16s| (channel + half) >> STEP.trailing_zeros();
    let differing = [(step(max) ^ step(min), Sample::COLOUR), (max ^ min, !Sample::COLOUR)];
    differing.map(|(bits, mask)| {
        let bits: S::u64s = bits.bitcast();
        (bits & S::u64s::splat(simd, mask)).simd_eq(S::u64s::splat(simd, 0)).to_bitmask()
    })
}
