use crate::grid::Bits;
use crate::lanes::*;
use crate::picture::Band;
use crate::prepare::Dither;
use crate::trace::Sample;
use fearless_simd::{i16x16, u8x32, u16x16, u32x8, u64x4};

/// The colours of four adjacent pixels, a word per channel, in 256ths of an output step.
type Four<S> = u16x16<S>;

/// Filled squares of a row, in pixels of the band. `x` and `y` are the position of square 0.
pub(super) struct Run<'a> {
    pub x: usize,
    pub y: usize,
    /// At least 1.
    pub level: usize,
    pub above: &'a [u64],
    pub below: &'a [u64],
    pub filled: Bits,
    pub flat: Bits,
    /// Rounding thresholds. The band's first row is a multiple of four in the picture.
    pub dither: &'a Dither,
}

#[inline(always)]
pub(super) fn fill<S: Simd>(simd: S, band: &mut Band<'_>, run: &Run<'_>) {
    by_isa!(simd: match run.level {
        1 => fill_by::<_, 1>(simd, band, run),
        2 => fill_by::<_, 2>(simd, band, run),
        _ => fill_by::<_, 3>(simd, band, run),
    });
}

/// Fills squares of `1 << LOG` pixels, and larger ones in parts.
#[inline(always)]
fn fill_by<S: Simd, const LOG: u32>(simd: S, band: &mut Band<'_>, run: &Run<'_>) {
    let halvings = if LOG < 3 { 0 } else { run.level as u32 - LOG };
    let parts = 1 << halvings;
    let mut aside = [0; MAX_PIXELS];
    run.filled.for_each(
        #[inline(always)]
        |i| {
            let (above, below) = (&run.above[i..i + 2], &run.below[i..i + 2]);
            let mut corners = [above[0], above[1], below[0], below[1]];
            if run.flat.has(i) {
                corners = [corners[0]; 4];
            }
            let (x, y) = (run.x + (i << run.level), run.y);
            for part in 0..parts * parts {
                let [i, j] = [part % parts, part / parts];
                let corners = part_corners(corners, [i, j], halvings);
                let (x, y) = (x + (i << LOG), y + (j << LOG));
                if x < band.width && y * band.stride + x < band.pixels.len() {
                    fill_part::<S, LOG>(simd, band, [x, y], corners, run.dither, &mut aside);
                }
            }
        },
    );
}

/// Fills one square, clipped to the picture.
#[inline(always)]
fn fill_part<S: Simd, const LOG: u32>(
    simd: S,
    band: &mut Band<'_>,
    [x, y]: [usize; 2],
    corners: [u64; 4],
    dither: &Dither,
    aside: &mut [u32; MAX_PIXELS],
) {
    let side = 1 << LOG;
    let start = y * band.stride + x;
    let end = start + (side - 1) * band.stride + side;
    let is_whole = x + side <= band.width && end <= band.pixels.len();
    let (pixels, stride) =
        if is_whole { (&mut band.pixels[start..], band.stride) } else { (&mut aside[..], side) };
    let (column, first_row) = if LOG == 1 { (x % 4, y) } else { (0, 0) };
    let thresholds = [0, 1, 2, 3].map(|row| {
        let row = &dither[(first_row + row) % 4];
        u64x4::from_slice(simd, &row[column..][..4]).bitcast()
    });
    fill_square::<S, LOG>(simd, corners, &thresholds, pixels, stride);
    if !is_whole {
        let rows = band.pixels[start..].chunks_mut(band.stride);
        let width = side.min(band.width - x);
        for (row, aside) in rows.zip(aside.chunks(side)).take(side) {
            row[..width].copy_from_slice(&aside[..width]);
        }
    }
}

/// Returns the corners of part (i, j) of `1 << halvings` along each side.
#[inline(always)]
fn part_corners(corners: [u64; 4], [i, j]: [usize; 2], halvings: u32) -> [u64; 4] {
    let mut corners = corners.map(Sample);
    for bit in (0..halvings).rev() {
        let [a, b, c, d] = corners;
        let (upper, lower) = (a.mean(b), c.mean(d));
        let [a, b, c, d] =
            if i >> bit & 1 == 0 { [a, upper, c, lower] } else { [upper, b, lower, d] };
        let (left, right) = (a.mean(c), b.mean(d));
        corners = if j >> bit & 1 == 0 { [a, b, left, right] } else { [left, right, c, d] };
    }
    corners.map(|corner| corner.0)
}

const MAX_PIXELS: usize = 64;

/// Interpolates the corners' colours over a square of `1 << LOG` pixels, and rounds them with
/// thresholds of period 4.
///
/// The sums never carry out of 16 bits. A step is off by at most half a 256th of an output step, so
/// the last pixel of a square of 8 is off by 7 of them; thresholds of 8 to 248 leave room for this.
#[inline(always)]
fn fill_square<S: Simd, const LOG: u32>(
    simd: S,
    corners: [u64; 4],
    thresholds: &[Four<S>; 4],
    pixels: &mut [u32],
    stride: usize,
) {
    let [a, b, c, d] = corners;
    let (a, b, c, d) = (four(simd, a), four(simd, b), four(simd, c), four(simd, d));
    let (across, across_below) = (step::<S, LOG>(b, a), step::<S, LOG>(d, c));
    let (upper, lower) = (a + a, c + c);
    let number = u16x16::simd_from(simd, [0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3]);
    let (mut first, lower) = (upper + across * number, lower + across_below * number);
    let first_down = step::<S, LOG>(lower >> 1, first >> 1);
    let (mut second, lower) = (first + across * 4, lower + across_below * 4);
    let second_down = step::<S, LOG>(lower >> 1, second >> 1);
    let side = 1 << LOG;
    let pixels = &mut pixels[..(side - 1) * stride + side];
    for y in 0..side {
        let threshold = thresholds[y % 4];
        let bytes: u8x32<S> = ((first + threshold) >> 8).relaxed_narrow((second + threshold) >> 8);
        let eight: u32x8<S> = bytes.bitcast();
        let row = &mut pixels[y * stride..y * stride + side];
        if LOG == 3 {
            eight.store_slice(row);
        } else {
            let eight: [u32; 8] = eight.into();
            row.copy_from_slice(&eight[..side]);
        }
        first += first_down;
        second += second_down;
    }
}

#[inline(always)]
fn four<S: Simd>(simd: S, sample: u64) -> Four<S> {
    u64x4::splat(simd, sample & Sample::COLOUR).bitcast()
}

/// Returns the increment between two numbers of 128ths over `2^LOG` steps, in 256ths, rounded.
#[inline(always)]
fn step<S: Simd, const LOG: u32>(to: Four<S>, from: Four<S>) -> Four<S> {
    let difference: i16x16<S> = (to - from).bitcast();
    // A single halving is exact; otherwise the rounding term cannot overflow.
    if LOG == 1 { difference.bitcast() } else { (((difference >> (LOG - 2)) + 1) >> 1).bitcast() }
}
