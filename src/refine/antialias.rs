//! Antialiasing: a pixel that differs from a neighbour gets the mean of several samples.
//!
//! Once all bands are drawn, each is looked at again. What is compared are the pixels as they were drawn, those of the
//! neighbouring bands too, and the samples of a pixel lie on a regular grid, so that a picture has the same bits for any
//! number of threads, and what is all alike keeps its bits. Samples are traced, in filled squares too.
//!
//! What is smaller than a pixel and lies between the samples of its neighbours is not found by this: a pixel is looked at
//! more closely only where something can be seen.

use super::{Band, MAX_BANDS, Worker};
use crate::MAX_WIDTH;
use crate::lanes::*;
use crate::prepare::Prepared;
use crate::quality::Quality;
use crate::scene::Scene;
use crate::trace::{BATCH, STEP, trace};
use fearless_simd::{Level, u8x16, u32x4};

/// The least difference of neighbours, in a channel and 255ths, that is an edge.
const EDGE: u8 = 16;

/// Pixels of a stretch of a band along x, whose rays meet the same groups.
const STRETCH: usize = 64;

/// What the second look at a frame needs.
pub(crate) struct Smoothing {
    /// The scene for a picture with a pixel for each sample.
    finer: Prepared,
    /// The first and the last row of each band, as they were drawn.
    seams: [[[u32; MAX_WIDTH]; 2]; MAX_BANDS],
}

/// Whether each pixel of a band is on an edge.
type Marks = [[bool; MAX_WIDTH]; Quality::MAX_SQUARE];

impl Smoothing {
    /// Room for any frame.
    pub const fn new() -> Self {
        Self {
            finer: Prepared::new(),
            seams: [[[0; MAX_WIDTH]; 2]; MAX_BANDS],
        }
    }

    /// Takes in a frame, `width` pixels wide and drawn from a scene as it was prepared.
    pub fn set(
        &mut self,
        scene: &Scene,
        prepared: &Prepared,
        quality: &Quality,
        width: usize,
        pixels: &[u32],
    ) {
        let n = quality.antialias;
        self.finer.offset = prepared.offset * n as f32;
        self.finer.set(scene, n * width, n * prepared.height);
        let bands = pixels.chunks(Band::rows(quality.square) * width);
        for (seam, band) in self.seams.iter_mut().zip(bands) {
            seam[0][..width].copy_from_slice(&band[..width]);
            seam[1][..width].copy_from_slice(&band[band.len() - width..]);
        }
    }

    /// Has the edges of a band of the frame traced by more samples.
    pub fn smooth(
        &self,
        level: Level,
        quality: &Quality,
        worker: &mut Worker,
        band: &mut Band<'_>,
    ) {
        // Marks of the method are no edges.
        if self.finer.shows_method() {
            return;
        }
        let mut marks = [[false; _]; _];
        #[cfg(target_arch = "x86_64")]
        if let Some(simd) = level.as_sse2() {
            self.mark(simd, quality, band, &mut marks);
        }
        #[cfg(not(target_arch = "x86_64"))]
        fearless_simd::dispatch!(level, simd => self.mark(simd, quality, band, &mut marks));
        self.trace_marked(level, quality, &marks, worker, band);
    }

    /// Traces the samples of a band's marked pixels.
    fn trace_marked(
        &self,
        level: Level,
        quality: &Quality,
        marks: &Marks,
        worker: &mut Worker,
        band: &mut Band<'_>,
    ) {
        let n = quality.antialias;
        let (width, height) = (band.width, band.pixels.len() / band.width);
        for start in (0..width).step_by(STRETCH) {
            let end = (start + STRETCH).min(width);
            let (left, top) = (n * start, n * band.top);
            let seen = self.finer.seen(left, top, n * end, top + n * height);
            let mut traced = |worker: &mut Worker| {
                trace(level, &self.finer, quality, seen, &mut worker.batch);
                take(n, worker, band);
            };
            for (y, marks) in marks.iter().enumerate().take(height) {
                for x in (start..end).filter(|&x| marks[x]) {
                    if worker.batch.len() + n * n > BATCH {
                        traced(worker);
                    }
                    for part in 0..n * n {
                        let (x, y) = (n * x + part % n, top + n * y + part / n);
                        worker.batch.push(x, y);
                    }
                }
            }
            traced(worker);
        }
    }

    /// Marks the pixels of a band that differ from one of their four neighbours.
    #[inline(always)]
    fn mark<S: Simd>(&self, simd: S, quality: &Quality, band: &Band<'_>, marks: &mut Marks) {
        let (width, rows) = (band.width, Band::rows(quality.square));
        let number = band.top / rows;
        let mut lines = band.pixels.chunks_exact(width).enumerate().peekable();
        if let (Some(above), Some((_, line))) = (number.checked_sub(1), lines.peek()) {
            let above = &self.seams[above][1];
            each_edge(simd, line, above, |x| marks[0][x] = true);
        }
        while let Some((y, line)) = lines.next() {
            each_edge(simd, line, &line[1..], |x| {
                marks[y][x] = true;
                marks[y][x + 1] = true;
            });
            if let Some((_, below)) = lines.peek() {
                each_edge(simd, line, below, |x| {
                    marks[y][x] = true;
                    marks[y + 1][x] = true;
                });
            } else if (band.top + y + 1) * quality.antialias < self.finer.height {
                let below = &self.seams[number + 1][0];
                each_edge(simd, line, below, |x| marks[y][x] = true);
            }
        }
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
    for first in (0..batch.len()).step_by(n * n) {
        let (x, y, ..) = batch.result(first);
        let mut pixel = 0;
        for channel in [32, 16, 0] {
            let value = |i: usize| (batch.result(i).2.0 >> channel & 0xffff) as u32;
            let sum: u32 = (first..first + n * n).map(value).sum();
            let steps = STEP as u32 * count;
            pixel = (pixel << 8) + (sum + steps / 2) / steps;
        }
        band.pixels[(y / n - band.top) * band.width + x / n] = pixel;
    }
    batch.clear();
}
