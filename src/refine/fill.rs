//! Fills squares with colours between those of their corners.

use super::square::{Corners, Square};
use crate::lanes::*;

/// The pixels of a band, row after row, `width` to a row.
pub(crate) struct Canvas<'a> {
    pub pixels: &'a mut [u32],
    pub width: usize,
    pub height: usize,
}

/// How a square's colours change: a number at its upper left corner, and what is added per pixel.
#[derive(Clone, Copy)]
struct Ramp {
    start: f32,
    across: f32,
    down: f32,
    /// Added to `across` per row.
    twist: f32,
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
        let (x, y, w) = (square.x as usize, square.y as usize, square.w as usize);
        for j in 0..self.rows(square) {
            let row = self.row(x, y + j, w);
            // The common length has its own way, which the compiler makes one store of.
            if let Ok(eight) = <&mut [u32; 8]>::try_from(&mut *row) {
                *eight = [pixel; 8];
            } else {
                for p in row {
                    *p = pixel;
                }
            }
        }
    }

    /// Interpolates the corners' colours along both sides.
    #[inline(always)]
    pub fn bilinear<S: Simd>(&mut self, simd: S, square: &Square, corners: Corners) {
        let (x, y) = (square.x as usize, square.y as usize);
        let (w, h) = (square.w as usize, square.h as usize);
        let ramp = |i| Ramp::between(corners, i, w, h);
        let ramps = [ramp(0), ramp(1), ramp(2)];
        let whole = x + w <= self.width && y + h <= self.height && w == h;
        match w {
            2 if whole => self.blocks::<S, 2>(simd, x, y, &ramps),
            4 if whole => self.blocks::<S, 4>(simd, x, y, &ramps),
            8 if whole => self.blocks::<S, 8>(simd, x, y, &ramps),
            16 if whole => self.blocks::<S, 16>(simd, x, y, &ramps),
            _ => {
                for j in 0..self.rows(square) {
                    for (i, pixel) in self.row(x, y + j, w).iter_mut().enumerate() {
                        *pixel = pixel_at(&ramps, i as f32, j as f32);
                    }
                }
            }
        }
    }

    /// Fills a square of side `W`, as many rows at a time as the lanes hold.
    #[inline(always)]
    fn blocks<S: Simd, const W: usize>(&mut self, simd: S, x: usize, y: usize, ramps: &[Ramp; 3]) {
        let rows = (LANES / W).min(W);
        let column = F::from_fn(
            simd,
            #[inline(always)]
            |lane| (lane % W) as f32,
        );
        let row = F::from_fn(
            simd,
            #[inline(always)]
            |lane| (lane / W) as f32,
        );
        let [b, g, r] = ramps;
        let mut r = r.spread(simd, column, row, rows as f32);
        let mut g = g.spread(simd, column, row, rows as f32);
        let mut b = b.spread(simd, column, row, rows as f32);
        let mut place = y * self.width + x;
        for _ in 0..W / rows {
            let pixels = r.next() << 16 | g.next() << 8 | b.next();
            for row in pixels.to_array().as_chunks::<W>().0.iter().take(rows) {
                if let Some(target) = self.pixels[place..].first_chunk_mut() {
                    *target = *row;
                }
                place += self.width;
            }
        }
    }
}

/// A [`Ramp`] in lanes, row after row.
struct Steps<S: Simd> {
    value: F<S>,
    step: F<S>,
}

impl<S: Simd> Steps<S> {
    /// The numbers of these rows, cut to whole ones.
    #[inline(always)]
    fn next(&mut self) -> U<S> {
        let whole: I<S> = self.value.to_int();
        self.value += self.step;
        whole.bitcast()
    }
}

impl Ramp {
    /// Channel `i` of a square of `w` by `h` pixels, with half of one added so that cutting off rounds.
    #[inline(always)]
    fn between(corners: Corners, i: usize, w: usize, h: usize) -> Self {
        let [a, b, c, d] = corners;
        let (a, b) = (a.channel(i), b.channel(i));
        let (c, d) = (c.channel(i), d.channel(i));
        let (w, h) = (1.0 / w as f32, 1.0 / h as f32);
        Self {
            start: a + 0.5,
            across: (b - a) * w,
            down: (c - a) * h,
            twist: (d - c - b + a) * w * h,
        }
    }

    /// The numbers at lanes' columns and rows, to be stepped `rows` rows at a time.
    #[inline(always)]
    fn spread<S: Simd>(&self, simd: S, column: F<S>, row: F<S>, rows: f32) -> Steps<S> {
        let down = fma(column, splat(simd, self.twist), splat(simd, self.down));
        let top = fma(column, splat(simd, self.across), splat(simd, self.start));
        Steps {
            value: fma(row, down, top),
            step: down * rows,
        }
    }
}

/// A pixel of a square, by its column and row.
fn pixel_at(ramps: &[Ramp; 3], column: f32, row: f32) -> u32 {
    let [b, g, r] = ramps.map(|ramp| {
        let across = ramp.across + ramp.twist * row;
        (ramp.start + ramp.down * row + across * column) as u32
    });
    r << 16 | g << 8 | b
}
