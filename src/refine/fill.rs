//! Fills a square with colours between those of its corners.

use super::square::{Corners, Square};
use crate::lanes::*;
use crate::trace::Sample;

/// The pixels of a band, row after row, `width` to a row.
pub(crate) struct Canvas<'a> {
    pub pixels: &'a mut [u32],
    pub width: usize,
    pub height: usize,
}

impl Canvas<'_> {
    /// The pixels of row `y` from `x` on, `w` of them or as many as the picture has.
    #[inline(always)]
    fn row(&mut self, x: usize, y: usize, w: usize) -> &mut [u32] {
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

    /// Sets the pixels from (x, y) to the right; they must be in the picture.
    #[inline(always)]
    pub fn put_run(&mut self, x: usize, y: usize, pixels: &[u32]) {
        self.row(x, y, pixels.len()).copy_from_slice(pixels);
    }

    /// One colour.
    #[inline(always)]
    pub fn flat(&mut self, square: &Square, pixel: u32) {
        for j in 0..self.rows(square) {
            self.row(square.x as usize, square.y as usize + j, square.w as usize)
                .fill(pixel);
        }
    }

    /// Interpolates the corners' colours along both sides.
    #[inline(always)]
    pub fn bilinear<S: Simd>(&mut self, simd: S, square: &Square, [a, b, c, d]: Corners<'_>) {
        let (w, h) = (square.w as usize, square.h as usize);
        let down = 1.0 / h as f32;
        let across = 1.0 / w as f32;
        let lane = F::from_fn(
            simd,
            #[inline(always)]
            |i| i as f32 * across,
        );
        for j in 0..self.rows(square) {
            let v = j as f32 * down;
            let left = Sample::between(a, c, v);
            let right = Sample::between(b, d, v);
            let row = self.row(square.x as usize, square.y as usize + j, w);
            for (i, part) in row.chunks_mut(LANES).enumerate() {
                let u = lane + (i * LANES) as f32 * across;
                let pixels = between(simd, u, left[0], right[0]) << 16
                    | between(simd, u, left[1], right[1]) << 8
                    | between(simd, u, left[2], right[2]);
                if let Ok(part) = <&mut [u32; LANES]>::try_from(&mut *part) {
                    pixels.store_array(part);
                } else {
                    let len = part.len();
                    part.copy_from_slice(&pixels.as_slice()[..len]);
                }
            }
        }
    }
}

/// Numbers from 0 to 255 at shares `u` of the way from one to another, rounded.
#[inline(always)]
fn between<S: Simd>(simd: S, u: F<S>, from: f32, to: f32) -> U<S> {
    // Half of one is added so that cutting off rounds.
    let i: I<S> = fma(u, splat(simd, to - from), splat(simd, from + 0.5)).to_int();
    i.bitcast()
}
