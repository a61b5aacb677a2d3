//! Enlarges small pictures, by all threads.
//!
//! In each direction, a pixel mixes three quarters of the nearest small pixel and a quarter of the
//! second nearest, which is bilinear interpolation at a factor of 2. At a factor of 3, the middle
//! pixel is a copy of the nearest. One thread enlarges to 3840x2160 in 7 ms; a copy takes 4 ms.

pub use crate::backend::memory::small;
use crate::pool::Pool;
use crate::render_target::{MAX_PIXELS, MAX_WIDTH};

/// The memory for small pictures, in pixels: the largest one is half as wide and high as the
/// largest frame. Pixels after its end are read, but not shown.
pub const MAX_SMALL: usize = MAX_PIXELS / 4 + LANES;

/// Pixels that are mixed at once.
const LANES: usize = 4;

type Lanes = [u32; LANES];

/// A row of the widest small picture, with a copy of the outermost pixel on each side.
type Line = [u32; MAX_WIDTH / 2 + LANES];

/// A picture in memory of [`MAX_SMALL`] pixels, as [`small`] returns.
pub struct Small<'a> {
    pub pixels: &'a [u32],
    pub width: usize,
    pub height: usize,
    /// The factor by which to enlarge it: 2 or 3.
    pub factor: u32,
    pub is_smooth: bool,
}

impl Small<'_> {
    /// Fills a canvas that is `width` pixels wide. It may cut off the last columns and rows.
    ///
    /// # Panics
    /// If a picture is too large or too small.
    pub fn enlarge(&self, pool: &mut Pool, canvas: &mut [u32], width: usize) {
        pool.rows(canvas, width, &|y, row| {
            let mut line = [0; _];
            self.mix_rows(y as u32, &mut line);
            self.stretch(&line, row);
        });
    }

    fn mix_rows(&self, y: u32, line: &mut Line) {
        let (nearest, side) = ((y / self.factor) as usize, y % self.factor);
        let mut neighbour = nearest;
        if self.is_smooth && side == 0 {
            neighbour = nearest.saturating_sub(1);
        } else if self.is_smooth && side == self.factor - 1 {
            neighbour = (nearest + 1).min(self.height - 1);
        }
        let row = |y: usize| self.pixels[y * self.width..].as_chunks().0;
        let pairs = row(nearest).iter().zip(row(neighbour));
        for (to, (&pixels, &others)) in line[1..].as_chunks_mut().0.iter_mut().zip(pairs) {
            *to = mix(pixels, others);
        }
        line[0] = line[1];
        line[self.width + 1] = line[self.width];
    }

    fn stretch(&self, line: &Line, row: &mut [u32]) {
        let mut at = 0;
        for &around in line.array_windows().take(self.width) {
            let mut mixed = [around[1]; LANES];
            if self.is_smooth {
                mixed = mix(mixed, around);
            }
            if self.factor == 2 {
                mixed[1] = mixed[2];
            }
            // The next pixel overwrites the lanes beyond the factor.
            match row.get_mut(at..at + LANES) {
                Some(to) => to.copy_from_slice(&mixed),
                None => {
                    let rest = row[at..].iter_mut().zip(mixed);
                    rest.for_each(|(to, pixel)| *to = pixel);
                }
            }
            at += self.factor as usize;
        }
    }
}

fn mix(pixels: Lanes, neighbours: Lanes) -> Lanes {
    mean(pixels, mean(pixels, neighbours))
}

/// Returns the mean of each channel, rounded up.
#[cfg(target_arch = "x86_64")]
fn mean(a: Lanes, b: Lanes) -> Lanes {
    use core::arch::x86_64::{__m128i, _mm_avg_epu8};
    use core::mem::transmute;
    let [a, b] = [a, b].map(|lanes| {
        // SAFETY: the types have the same size and no invalid values.
        unsafe { transmute::<Lanes, __m128i>(lanes) }
    });
    // SAFETY: the same, and every such processor has SSE2.
    unsafe { transmute::<__m128i, Lanes>(_mm_avg_epu8(a, b)) }
}

#[cfg(not(target_arch = "x86_64"))]
fn mean(a: Lanes, b: Lanes) -> Lanes {
    core::array::from_fn(|i| (a[i] | b[i]) - ((a[i] ^ b[i]) >> 1 & 0x7f7f_7f7f))
}
