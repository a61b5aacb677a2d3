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
    /// Sets one pixel, if it is in the picture.
    #[inline(always)]
    pub fn put(&mut self, x: usize, y: usize, pixel: u32) {
        if x < self.width && y < self.height {
            let place = self.pixels.get_mut(y * self.width + x);
            *place.unwrap_or(&mut 0) = pixel;
        }
    }

    /// Interpolates the corners' colours along both sides of a square, as far as it is in the picture. The pixels of the
    /// upper and the left side get the bits `side` too.
    ///
    /// (Out of line where bytes count for more than time.)
    #[inline(always)]
    pub fn fill<S: Simd>(&mut self, simd: S, square: &Square, corners: &Corners, side: u32) {
        let (x, y, w, h) = square.place();
        let (right, below) = ((x + w).min(self.width), (y + h).min(self.height));
        if !(w == h && w.is_power_of_two()) {
            for j in 0..below - y {
                for i in 0..right - x {
                    let side = if i == 0 || j == 0 { side } else { 0 };
                    self.put(x + i, y + j, between(corners, [i, j], [w, h]) | side);
                }
            }
            return;
        }
        let mut columns = Columns::between(simd, corners, w);
        let upper = u32x4::splat(simd, side);
        let mut left = u32x4::simd_from(simd, [side, 0, 0, 0]);
        for x in steps(x, right, 4) {
            let mut side = upper;
            let (mut a, a_down) = columns.next();
            let (mut b, b_down) = columns.next();
            for y in y..below {
                let bytes: u8x16<S> = (a >> 8).narrow(b >> 8);
                let mut four = bytes.bitcast::<u32x4<S>>();
                four |= side;
                side = left;
                let four: [u32; 4] = four.into();
                let row = self
                    .pixels
                    .get_mut(y * self.width + x..)
                    .unwrap_or_default();
                match row.first_chunk_mut() {
                    Some(pixels) if x + 4 <= right => *pixels = four,
                    _ => {
                        for (pixel, colour) in row.iter_mut().zip(four).take(right - x) {
                            *pixel = colour;
                        }
                    }
                }
                a += a_down;
                b += b_down;
            }
            left = u32x4::splat(simd, 0);
        }
    }
}

/// The upper and the lower side of a square, two pixels at a time.
///
/// All is added up without a carry out of 16 bits, so that differences of any size work. A step is off by half a 256th of
/// an output step at most, so that the last pixel of a square of 8 is off by 7 of them, and by 31 in one of 32.
struct Columns<S: Simd> {
    /// The side is two to this power.
    log: u32,
    upper: Pair<S>,
    lower: Pair<S>,
    /// From two pixels to the next two.
    upper_step: Pair<S>,
    lower_step: Pair<S>,
}

impl<S: Simd> Columns<S> {
    /// Between the corners of a square whose side is a power of two and at least 2.
    #[inline(always)]
    fn between(simd: S, corners: &Corners, side: usize) -> Self {
        let [a, b, c, d] = *corners;
        let log = side.trailing_zeros();
        let second: Pair<S> = u64x2::simd_from(simd, [0, u64::MAX]).bitcast();
        let (a, b, c, d) = (
            twice(simd, a),
            twice(simd, b),
            twice(simd, c),
            twice(simd, d),
        );
        let (across, across_below) = (step(b, a, log), step(d, c, log));
        Self {
            log,
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
        let down = step(self.lower >> 1, self.upper >> 1, self.log);
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

/// The way from one number of 128ths to another in `2^log` steps, in 256ths, rounded.
#[inline(always)]
fn step<S: Simd>(to: Pair<S>, from: Pair<S>, log: u32) -> Pair<S> {
    let way: i16x8<S> = (to - from).bitcast();
    // Of two steps each is the way; else half is added to a quarter of the range of words at most.
    let round = (log - 1).min(1);
    (((way >> (log - 1 - round)) + round as i16) >> round).bitcast()
}

/// The colour at a column and row of a square of any sides.
fn between(corners: &Corners, [i, j]: [usize; 2], [w, h]: [usize; 2]) -> u32 {
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
