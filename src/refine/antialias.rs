//! Antialiasing: a pixel that differs from a neighbour gets the mean of several samples.
//!
//! Once all bands are drawn, each is looked at again. What is compared are the pixels as they were drawn, those of the
//! neighbouring bands too, and the samples of a pixel lie on a regular grid, so that a picture has the same bits for any
//! number of threads, and what is all alike keeps its bits. Samples are traced, in filled squares too.
//!
//! What is smaller than a pixel and lies between the samples of its neighbours is not found by this: a pixel is looked at
//! more closely only where something can be seen.

use super::{Band, MAX_BANDS, TILE_HEIGHT, Worker};
use crate::MAX_WIDTH;
use crate::lanes::*;
use crate::prepare::Prepared;
use crate::quality::Quality;
use crate::trace::{BATCH, STEP, trace};
use fearless_simd::{Level, u8x16, u32x4};

/// The least difference of neighbours, in a channel and 255ths, that is an edge.
const EDGE: u8 = 16;

/// Pixels of a stretch of a band along x, whose rays meet the same groups: as many as a word has marks.
const STRETCH: usize = u64::BITS as usize;

/// A bit for each pixel of a row, number 0 in the lowest bit of the first word: whether it is on an edge.
type RowMarks = [u64; MAX_WIDTH.div_ceil(STRETCH)];

/// The pixels of a band that are on edges.
type Marks = [RowMarks; TILE_HEIGHT];

/// Where a band's last row differs by an edge from the row below it, the first of the next band, as both were drawn.
///
/// By the time that a band is looked at again, its neighbours may have been already. (Bits: the rows themselves would take 2 MB.)
pub(crate) struct Seams([RowMarks; MAX_BANDS]);

impl Seams {
    /// Of no frame.
    pub const fn new() -> Self {
        Self([[0; _]; MAX_BANDS])
    }

    /// Takes in a frame that is drawn, `width` pixels wide.
    pub fn set(&mut self, quality: &Quality, width: usize, pixels: &[u32]) {
        let rows = Band::rows(quality) * width;
        // The last band has none below it.
        let ends = (rows..pixels.len()).step_by(rows).map(Some);
        for (seam, end) in self.0.iter_mut().zip(ends.chain([None])) {
            *seam = [0; _];
            if let Some(end) = end {
                let (above, below) = (&pixels[end - width..end], &pixels[end..end + width]);
                each_edge(baseline(), above, below, |x| set(seam, x));
            }
        }
    }

    /// Has the edges of a band of the frame traced by more samples; `finer` is the scene for a picture with a pixel for each
    /// sample.
    pub fn smooth(
        &self,
        level: Level,
        finer: &Prepared,
        quality: &Quality,
        worker: &mut Worker,
        band: &mut Band<'_>,
    ) {
        // Marks of the method are no edges.
        if finer.shows_method() {
            return;
        }
        let mut marks = [[0; _]; _];
        self.mark(baseline(), quality, band, &mut marks);
        trace_marked(level, finer, quality, &marks, worker, band);
    }

    /// Marks the pixels of a band that differ from one of their four neighbours.
    #[inline(always)]
    fn mark<S: Simd>(&self, simd: S, quality: &Quality, band: &Band<'_>, marks: &mut Marks) {
        let number = band.top / Band::rows(quality);
        if let Some(above) = number.checked_sub(1) {
            marks[0] = self.0[above];
        }
        let mut lines = band.pixels.chunks_exact(band.width).enumerate().peekable();
        while let Some((y, line)) = lines.next() {
            each_edge(simd, line, &line[1..], |x| {
                set(&mut marks[y], x);
                set(&mut marks[y], x + 1);
            });
            if let Some((_, below)) = lines.peek() {
                each_edge(simd, line, below, |x| {
                    set(&mut marks[y], x);
                    set(&mut marks[y + 1], x);
                });
            } else {
                for (mark, seam) in marks[y].iter_mut().zip(&self.0[number]) {
                    *mark |= seam;
                }
            }
        }
    }
}

/// Marks a pixel of a row.
#[inline(always)]
fn set(row: &mut RowMarks, x: usize) {
    row[x / STRETCH] |= 1 << (x % STRETCH);
}

/// Traces the samples of a band's marked pixels.
fn trace_marked(
    level: Level,
    finer: &Prepared,
    quality: &Quality,
    marks: &Marks,
    worker: &mut Worker,
    band: &mut Band<'_>,
) {
    worker.batch.begin();
    let n = quality.antialias;
    let (width, height) = (band.width, band.pixels.len() / band.width);
    for (word, start) in (0..width).step_by(STRETCH).enumerate() {
        let end = (start + STRETCH).min(width);
        let (left, top) = (n * start, n * band.top);
        let seen = finer.visible_groups(left, top, n * end, top + n * height);
        let mut traced = |worker: &mut Worker| {
            trace(level, finer, quality, seen, &mut worker.batch);
            take(n, worker, band);
        };
        for (y, marks) in marks.iter().enumerate().take(height) {
            let mut rest = marks[word];
            while rest != 0 {
                let x = start + rest.trailing_zeros() as usize;
                rest &= rest - 1;
                if worker.batch.points.len() + n * n > BATCH {
                    traced(worker);
                }
                for part in 0..n * n {
                    let (x, y) = (n * x + part % n, top + n * y + part / n);
                    worker.batch.points.push(x, y);
                }
            }
        }
        traced(worker);
    }
}

/// Calls for each place where two lines of pixels differ by an edge.
#[inline(always)]
fn each_edge<S: Simd>(simd: S, a: &[u32], b: &[u32], mut call: impl FnMut(usize)) {
    let edge = u8x16::splat(simd, EDGE);
    for (i, (a, b)) in a.chunks(4).zip(b.chunks(4)).enumerate() {
        if let ([_, _, _, _], [_, _, _, _]) = (a, b) {
            let [a, b]: [u8x16<S>; 2] = [a, b].map(|x| u32x4::from_slice(simd, x).bitcast());
            if !(a.max(b) - a.min(b)).simd_ge(edge).any_true() {
                continue;
            }
        }
        for (j, (a, b)) in a.iter().zip(b).enumerate() {
            let channels = a.to_ne_bytes().into_iter().zip(b.to_ne_bytes());
            if channels.map(|(a, b)| a.abs_diff(b)).any(|d| d >= EDGE) {
                call(4 * i + j);
            }
        }
    }
}

/// Gives the pixels of a traced batch the means of their samples, rounded, and clears it.
fn take(n: usize, worker: &mut Worker, band: &mut Band<'_>) {
    let batch = &mut worker.batch;
    let count = (n * n) as u32;
    for first in (0..batch.points.len()).step_by(n * n) {
        let (x, y) = batch.points.position(first);
        let mut pixel = 0;
        for channel in [32, 16, 0] {
            let value = |i: usize| (batch.results.sample(i).0.0 >> channel & 0xffff) as u32;
            let sum: u32 = (first..first + n * n).map(value).sum();
            let steps = STEP as u32 * count;
            pixel = (pixel << 8) + (sum + steps / 2) / steps;
        }
        band.pixels[(y / n - band.top) * band.width + x / n] = pixel;
    }
    batch.points.clear();
}
