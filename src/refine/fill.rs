//! Fills squares with colours between those of their corners.

use super::square::{Corners, Square};
use crate::lanes::*;
use crate::trace::{STEP, Sample};
use fearless_simd::{i16x8, u8x16, u16x8, u32x4, u64x2};

/// The pixels of a band, row after row, `width` to a row.
pub(crate) struct Canvas<'a> {
    pub pixels: &'a mut [u32],
    pub width: usize,
    pub height: usize,
}

/// The colours of two neighbouring pixels, a word for each channel, in 256ths of an output step.
type Pair<S> = u16x8<S>;

/// Half an output step: added before the fraction is cut off, it rounds.
const HALF: u16 = 128;

impl Canvas<'_> {
    /// The pixels of row `y` from `x` on, `w` of them.
    #[inline(always)]
    pub fn row(&mut self, x: usize, y: usize, w: usize) -> &mut [u32] {
        &mut self.pixels[y * self.width + x..][..w]
    }

    /// Sets one pixel, if it is in the picture.
    #[inline(always)]
    pub fn put(&mut self, x: usize, y: usize, pixel: u32) {
        if x < self.width && y < self.height {
            self.pixels[y * self.width + x] = pixel;
        }
    }

    /// One colour.
    #[inline(always)]
    pub fn flat<S: Simd>(&mut self, simd: S, square: &Square, pixel: u32) {
        let (x, y) = (square.x as usize, square.y as usize);
        let end = (x + square.w as usize).min(self.width);
        let below = (y + square.h as usize).min(self.height);
        let pixels = &mut self.pixels[y * self.width..below * self.width];
        for row in pixels.chunks_exact_mut(self.width) {
            let (fours, rest) = row[x..end].as_chunks_mut::<4>();
            for four in fours {
                u32x4::splat(simd, pixel).store_array(four);
            }
            rest.fill(pixel);
        }
    }

    /// Interpolates the corners' colours along both sides.
    #[inline(always)]
    pub fn bilinear<S: Simd>(&mut self, simd: S, square: &Square, corners: Corners) {
        let (x, y) = (square.x as usize, square.y as usize);
        let (w, h) = (square.w as usize, square.h as usize);
        if w == 2 && h == 2 {
            let [a, b, c, d] = corners;
            let (upper, left) = (a.mean(b), a.mean(c));
            self.put(x, y, a.pixel());
            self.put(x + 1, y, upper.pixel());
            self.put(x, y + 1, left.pixel());
            self.put(x + 1, y + 1, upper.mean(c.mean(d)).pixel());
            return;
        }
        let is_whole = x + w <= self.width && y + h <= self.height;
        if is_whole && w == h && w.is_power_of_two() && w > 1 {
            let mut columns = Columns::between(simd, corners, w);
            for left in steps(0, w, 4) {
                self.four_columns(y * self.width + x + left, &mut columns);
            }
            return;
        }
        for j in 0..h {
            for i in 0..w {
                self.put(x + i, y + j, between(corners, [i, j], [w, h]));
            }
        }
    }

    /// Fills the next four columns of a square, the first pixel at `place`.
    #[inline(always)]
    fn four_columns<S: Simd>(&mut self, place: usize, columns: &mut Columns<S>) {
        let (mut left, left_down) = columns.next();
        let (mut right, right_down) = columns.next();
        let end = place + (columns.side - 1) * self.width + 4;
        for row in self.pixels[place..end].chunks_mut(self.width) {
            if let Some(four) = row.first_chunk_mut() {
                let bytes: u8x16<S> = (left >> 8).narrow(right >> 8);
                bytes.bitcast::<u32x4<S>>().store_array(four);
            }
            left += left_down;
            right += right_down;
        }
    }
}

/// The upper and the lower side of a square, two pixels at a time.
///
/// All is added up without a carry out of 16 bits, so that differences of any size work. A step is off by half a 256th of
/// an output step at most, so that the last pixel of a square of 8 is off by 7 of them, and by 31 in one of 32.
struct Columns<S: Simd> {
    side: usize,
    shift: u32,
    upper: Pair<S>,
    lower: Pair<S>,
    /// From two pixels to the next two.
    upper_step: Pair<S>,
    lower_step: Pair<S>,
}

impl<S: Simd> Columns<S> {
    /// Between the corners of a square whose side is a power of two and at least 4.
    #[inline(always)]
    fn between(simd: S, [a, b, c, d]: Corners, side: usize) -> Self {
        let shift = side.trailing_zeros() - 1;
        let second: Pair<S> = u64x2::simd_from(simd, [0, u64::MAX]).bitcast();
        let (a, b, c, d) = (
            twice(simd, a),
            twice(simd, b),
            twice(simd, c),
            twice(simd, d),
        );
        let (across, across_below) = (step(b, a, shift), step(d, c, shift));
        Self {
            side,
            shift,
            upper: a + a + HALF + (across & second),
            lower: c + c + HALF + (across_below & second),
            upper_step: across + across,
            lower_step: across_below + across_below,
        }
    }

    /// The next two pixels of the upper side, and what is added from row to row below them.
    #[inline(always)]
    fn next(&mut self) -> (Pair<S>, Pair<S>) {
        let value = self.upper;
        let down = step(self.lower >> 1, self.upper >> 1, self.shift);
        self.upper += self.upper_step;
        self.lower += self.lower_step;
        (value, down)
    }
}

/// A sample for both pixels of a pair, as it counts: in 128ths of an output step.
#[inline(always)]
fn twice<S: Simd>(simd: S, sample: Sample) -> Pair<S> {
    u64x2::splat(simd, sample.colour()).bitcast()
}

/// The way from one number of 128ths to another in `2^(shift + 1)` steps, in 256ths, rounded.
#[inline(always)]
fn step<S: Simd>(to: Pair<S>, from: Pair<S>, shift: u32) -> Pair<S> {
    let way: i16x8<S> = (to - from).bitcast();
    // Half is added to a quarter of the range of words at most.
    (((way >> (shift - 1)) + 1) >> 1).bitcast()
}

/// The colour at a column and row of a square of any sides.
fn between(corners: Corners, [i, j]: [usize; 2], [w, h]: [usize; 2]) -> u32 {
    let [a, b, c, d] = corners.map(|corner| corner.colour());
    let (step, area) = (STEP as usize, w * h);
    let channel = |shift: u32| {
        let at = |sample: u64| (sample >> shift & 0xffff) as usize;
        let upper = at(a) * (w - i) + at(b) * i;
        let lower = at(c) * (w - i) + at(d) * i;
        let sum = upper * (h - j) + lower * j;
        (sum + step * area / 2) / (step * area)
    };
    (channel(32) << 16 | channel(16) << 8 | channel(0)) as u32
}
