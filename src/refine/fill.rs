//! Fills squares with colours between those of their corners.

use super::square::{Corners, Square};
use crate::lanes::*;
use crate::trace::{STEP, Sample};
use fearless_simd::{f32x4, i32x4, u16x8, u32x8, u64x2};

/// The pixels of a band, row after row, `width` to a row.
pub(crate) struct Canvas<'a> {
    pub pixels: &'a mut [u32],
    pub width: usize,
    pub height: usize,
}

/// How a square's colours change: blue, green and red at its upper left corner, and what is added per pixel.
///
/// Half of one is added to all, so that cutting off rounds.
#[derive(Clone, Copy)]
struct Ramp<S: Simd> {
    start: f32x4<S>,
    across: f32x4<S>,
    down: f32x4<S>,
    /// Added to `down` per column.
    twist: f32x4<S>,
}

impl Canvas<'_> {
    /// The pixels of row `y` from `x` on, `w` of them or as many as the picture has.
    #[inline(always)]
    pub fn row(&mut self, x: usize, y: usize, w: usize) -> &mut [u32] {
        let end = (x + w).min(self.width);
        &mut self.pixels[y * self.width..][x..end]
    }

    /// The rows of a square that are in the picture.
    #[inline(always)]
    fn rows(&self, square: &Square) -> usize {
        (square.h as usize).min(self.height - square.y as usize)
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
        let (x, y, w) = (square.x as usize, square.y as usize, square.w as usize);
        let rows = self.rows(square);
        let pixels = &mut self.pixels[y * self.width..(y + rows) * self.width];
        for row in pixels.chunks_exact_mut(self.width) {
            let row = &mut row[x..];
            // The common length has its own way.
            match row.first_chunk_mut::<8>() {
                Some(eight) if w == 8 => u32x8::splat(simd, pixel).store_array(eight),
                _ => row.iter_mut().take(w).for_each(|p| *p = pixel),
            }
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
        let ramp = Ramp::between(simd, corners, w, h);
        let is_whole = x + w <= self.width && y + h <= self.height;
        if is_whole && w == h && w.is_power_of_two() {
            self.ramp(simd, x, y, w, &ramp);
        } else {
            for j in 0..self.rows(square) {
                for (i, pixel) in self.row(x, y + j, w).iter_mut().enumerate() {
                    *pixel = ramp.pixel_at(i as f32, j as f32);
                }
            }
        }
    }

    /// Fills a square whose side is a power of two, as many pixels at a time as there are lanes.
    #[inline(always)]
    fn ramp<S: Simd>(&mut self, simd: S, x: usize, y: usize, side: usize, ramp: &Ramp<S>) {
        let columns = lanes::<S>().min(side);
        let rows = (lanes::<S>() / columns).min(side);
        let lane = numbers(simd);
        let lane_row: I<S> = (lane >> columns.trailing_zeros()).bitcast();
        let lane_column: I<S> = (lane & (columns as u32 - 1)).bitcast();
        let row: F<S> = lane_row.to_float();
        for left in steps(0, side, columns) {
            let column: F<S> = lane_column.to_float::<F<S>>() + left as f32;
            let mut b = Steps::new(simd, ramp, 0, column, row, rows as f32);
            let mut g = Steps::new(simd, ramp, 1, column, row, rows as f32);
            let mut r = Steps::new(simd, ramp, 2, column, row, rows as f32);
            let mut place = y * self.width + x + left;
            for _ in 0..side / rows {
                let pixels = r.next() << 16 | g.next() << 8 | b.next();
                let mut pixels = pixels.as_slice();
                for _ in 0..rows {
                    let (run, rest) = pixels.split_at(columns);
                    copy(run, &mut self.pixels[place..place + columns]);
                    pixels = rest;
                    place += self.width;
                }
            }
        }
    }
}

/// Copies a run of 2, 4, 8 or 16 pixels, each by a move of its own: the compiler makes a call of a loop.
#[inline(always)]
fn copy(from: &[u32], to: &mut [u32]) {
    #[inline(always)]
    fn exactly<const N: usize>(from: &[u32], to: &mut [u32]) {
        if let (Some(from), Some(to)) = (from.first_chunk::<N>(), to.first_chunk_mut::<N>()) {
            *to = *from;
        }
    }
    match from.len() {
        2 => exactly::<2>(from, to),
        4 => exactly::<4>(from, to),
        8 => exactly::<8>(from, to),
        _ => exactly::<16>(from, to),
    }
}

/// A [`Ramp`] in lanes, some rows at a time.
struct Steps<S: Simd> {
    value: F<S>,
    step: F<S>,
}

impl<S: Simd> Steps<S> {
    /// Channel `i` at the lanes' columns and rows, to be stepped `rows` rows at a time.
    #[inline(always)]
    fn new(simd: S, ramp: &Ramp<S>, i: usize, column: F<S>, row: F<S>, rows: f32) -> Self {
        let down = column.mul_add(splat(simd, ramp.twist[i]), splat(simd, ramp.down[i]));
        let top = column.mul_add(splat(simd, ramp.across[i]), splat(simd, ramp.start[i]));
        Self {
            value: row.mul_add(down, top),
            step: down * rows,
        }
    }

    /// The numbers of these rows, cut to whole ones.
    #[inline(always)]
    fn next(&mut self) -> U<S> {
        let whole: I<S> = self.value.to_int();
        self.value += self.step;
        whole.bitcast()
    }
}

impl<S: Simd> Ramp<S> {
    /// Between the corners of a square of `w` by `h` pixels.
    #[inline(always)]
    fn between(simd: S, [a, b, c, d]: Corners, w: usize, h: usize) -> Self {
        let (a, b) = channels(simd, a, b);
        let (c, d) = channels(simd, c, d);
        let (w, h) = (1.0 / w as f32, 1.0 / h as f32);
        Self {
            start: a + 0.5,
            across: (b - a) * w,
            down: (c - a) * h,
            twist: (d - c - b + a) * (w * h),
        }
    }

    /// A pixel by its column and row.
    #[inline(always)]
    fn pixel_at(&self, column: f32, row: f32) -> u32 {
        let colour = self.start + self.across * column + (self.down + self.twist * column) * row;
        (colour[2] as u32) << 16 | (colour[1] as u32) << 8 | colour[0] as u32
    }
}

/// Blue, green and red of two samples, in steps.
#[inline(always)]
fn channels<S: Simd>(simd: S, a: Sample, b: Sample) -> (f32x4<S>, f32x4<S>) {
    let both: u16x8<S> = u64x2::simd_from(simd, [a.0, b.0]).bitcast();
    let (a, b) = both.widen();
    let (a, b): (i32x4<S>, i32x4<S>) = (a.bitcast(), b.bitcast());
    let (a, b): (f32x4<S>, f32x4<S>) = (a.to_float(), b.to_float());
    (a * (1.0 / STEP as f32), b * (1.0 / STEP as f32))
}
