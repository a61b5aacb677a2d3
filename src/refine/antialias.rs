//! Antialiasing: pixels that differ by an edge are mixed with the point half-way between them.
//!
//! Once all bands are drawn, each is looked at again. Where two neighbours differ by an edge, the point in the middle between them
//! is traced, once for both. Each of the two becomes
//!
//! ```text
//!     a       middle      b
//!   +---------+---------+
//!   |         |   /     |        a = 2/3 a + 1/3 middle
//!   |    x    o  / x    |        b = 2/3 b + 1/3 middle
//!   |         | /       |
//!   +---------+---------+        Here the middle is like a, so that b alone changes, which the edge cuts.
//!               an edge
//! ```
//!
//! and the mean of that along x and along y if it differs along both. As an edge goes from a pixel to the next, the two take steps
//! of a third. So points are traced on edges alone, and a single one for each row or column that an edge goes through, where a
//! grid of four in each pixel would take eight. What is compared are the pixels as they were drawn, those of the neighbouring bands
//! too, so that a picture has the same bits for any number of threads, and what is all alike keeps its bits.
//!
//! What is smaller than a pixel and lies between the samples of its neighbours is not found by this: a pixel is looked at
//! more closely only where something can be seen.

use super::middles::STRETCH;
use super::{Band, MAX_BANDS, TILE_HEIGHT, Worker};
use crate::MAX_WIDTH;
use crate::lanes::*;
use crate::observe::{Observer, Stage};
use crate::prepare::{Prepared, rectangle};
use crate::quality::Quality;
use crate::trace::{BATCH, STEP, Sample, trace};
use fearless_simd::{Level, u8x32, u32x8};

/// The least difference of neighbours, in a channel and 255ths, that is an edge.
const EDGE: u8 = 20;

/// Positions are counted in halves of a pixel.
pub(super) const PARTS: usize = 2;

/// Bits of a channel in a sum of points: enough for the four beside a pixel.
const FIELD: usize = 21;

/// A bit for each pixel of a row, number 0 in the lowest bit of the first word: whether it differs from a certain neighbour.
type RowMarks = [u64; MAX_WIDTH.div_ceil(STRETCH)];

/// Where the pixels of a band differ from their neighbours.
///
/// Each row has two: from the one above, and from the one to the right. The last are those of the row below the band from the one
/// above it.
struct Marks([RowMarks; PARTS * TILE_HEIGHT + 1]);

/// Where a band's last row differs from the row below it, the first of the next band, as both were drawn.
///
/// By the time that a band is looked at again, its neighbours may have been already. (Bits: the rows themselves would take 2 MB.)
pub(crate) struct Seams([RowMarks; MAX_BANDS]);

impl Seams {
    /// Of no frame.
    pub const fn new() -> Self {
        Self([[0; _]; MAX_BANDS])
    }

    /// Takes in a frame that is drawn, `width` pixels wide, of whose columns so many are finished, one at least.
    pub fn set(
        &mut self,
        isa: Level,
        quality: &Quality,
        width: usize,
        finished: usize,
        pixels: &[u32],
    ) {
        let rows = Band::rows(quality) * width;
        // The last band has none below it.
        let ends = (rows..pixels.len()).step_by(rows).map(Some);
        for (seam, end) in self.0.iter_mut().zip(ends.chain([None])) {
            *seam = [0; _];
            if let Some(end) = end {
                let (above, below) = (&pixels[end - width..], &pixels[end..]);
                mark(isa, &above[..finished], &below[..finished], seam);
            }
        }
    }

    /// Smooths the edges of a band of the frame. The observer hears of the stages.
    pub fn smooth<O: Observer>(
        &self,
        isa: Level,
        scene: &Prepared,
        quality: &Quality,
        observer: O,
        worker: &mut Worker,
        band: &mut Band<'_>,
    ) {
        observer.stage(Stage::Edges);
        let mut marks = Marks([[0; _]; _]);
        self.mark(isa, quality, scene.finished_columns(), band, &mut marks);
        mix(isa, scene, quality, observer, &marks, worker, band);
    }

    /// Marks where the finished pixels of a band differ from their neighbours: marks of the method are no edges.
    ///
    /// They are put into what the caller has: two more copies on the way there would be most of what a thread's stack takes.
    fn mark(
        &self,
        isa: Level,
        quality: &Quality,
        finished: usize,
        band: &Band<'_>,
        marks: &mut Marks,
    ) {
        let number = band.top / Band::rows(quality);
        if let Some(above) = number.checked_sub(1) {
            marks.0[0] = self.0[above];
        }
        let lines = band.pixels.chunks_exact(band.width);
        let mut lines = lines.map(|line| &line[..finished]).enumerate().peekable();
        while let Some((y, line)) = lines.next() {
            mark(isa, line, &line[1..], &mut marks.0[PARTS * y + 1]);
            let below = &mut marks.0[PARTS * y + 2];
            match lines.peek() {
                Some((_, next)) => mark(isa, line, next, below),
                None => *below = self.0[number],
            }
        }
    }
}

/// Marks where two lines of pixels differ by an edge, as far as both go.
fn mark(isa: Level, a: &[u32], b: &[u32], marks: &mut RowMarks) {
    by_isa!(isa, simd => mark_by(simd, a, b, marks));
}

#[inline(always)]
fn mark_by<S: Simd>(simd: S, a: &[u32], b: &[u32], marks: &mut RowMarks) {
    let (eights_a, rest_a) = a[..b.len()].as_chunks();
    let (eights_b, rest_b) = b.as_chunks();
    for (i, (&a, &b)) in eights_a.iter().zip(eights_b).enumerate() {
        marks[8 * i / STRETCH] |= edges(simd, a, b) << (8 * i % STRETCH);
    }
    let rest = rest_a.iter().zip(rest_b);
    for (x, (&a, &b)) in (8 * eights_b.len()..).zip(rest) {
        marks[x / STRETCH] |= (edges(simd, [a; 8], [b; 8]) & 1) << (x % STRETCH);
    }
}

/// Which of eight pixels differ from eight others by an edge.
#[inline(always)]
fn edges<S: Simd>(simd: S, a: [u32; 8], b: [u32; 8]) -> u64 {
    let [a, b]: [u8x32<S>; 2] = [a, b].map(|eight| u32x8::simd_from(simd, eight).bitcast());
    let over = (a.max(b) - a.min(b)).saturating_sub(EDGE - 1);
    let over: u32x8<S> = over.bitcast();
    (!over.simd_eq(0)).to_bitmask()
}

/// Whether two pixels differ by an edge.
pub(super) fn is_edge(a: u32, b: u32) -> bool {
    let mut channels = a.to_le_bytes().into_iter().zip(b.to_le_bytes());
    channels.any(|(a, b)| a.abs_diff(b) >= EDGE)
}

/// Traces the points between a band's pixels that differ, and mixes them.
fn mix<O: Observer>(
    isa: Level,
    scene: &Prepared,
    quality: &Quality,
    observer: O,
    marks: &Marks,
    worker: &mut Worker,
    band: &mut Band<'_>,
) {
    worker.batch.begin(PARTS);
    let (width, top, height) = (band.width, band.top, band.pixels.len() / band.width);
    for (word, start) in (0..width).step_by(STRETCH).enumerate() {
        // Points lie up to half a pixel outside.
        let (left, above) = (start.saturating_sub(1), top.saturating_sub(1));
        let rect = rectangle(left, above, start + STRETCH, top + height);
        let seen = scene.visible_groups(scene.axes.rect(rect));
        let traced = |worker: &mut Worker| {
            observer.stage(Stage::Middles);
            trace(isa, scene, quality, seen, &mut worker.batch);
            observer.stage(Stage::Edges);
            add_middles([start, top], height, worker);
        };
        for (number, row) in marks.0[..=PARTS * height].iter().enumerate() {
            if worker.batch.points.len() + STRETCH + 1 > BATCH {
                traced(worker);
            }
            let points = &mut worker.batch.points;
            let (x, y) = (
                PARTS * start + number % PARTS,
                (PARTS * top + number).wrapping_sub(1),
            );
            // Between the last pixel of the stretch before and the first of this one.
            if number % PARTS != 0 && before(row, word) != 0 {
                points.push(x - PARTS, y);
            }
            each(row[word], |bit| points.push(x + PARTS * bit, y));
        }
        traced(worker);
        let rows = band.pixels.chunks_exact_mut(width).enumerate();
        for (y, row) in rows {
            let sides = marks.sides(y, word);
            let [left, right, above, below] = sides;
            each(left | right | above | below, |bit| {
                let count = sides.map(|side| (side >> bit & 1) as usize);
                let sum = core::mem::take(&mut worker.middles[y][bit]);
                let pixel = &mut row[start + bit];
                *pixel = mixed(*pixel, sum, count);
            });
        }
    }
}

impl Marks {
    /// The marks of the pixels of a stretch: whether each differs from the one to the left, to the right, above and below.
    fn sides(&self, y: usize, word: usize) -> [u64; 4] {
        let rows = &self.0[PARTS * y..][..3];
        let right = rows[1][word];
        let left = right << 1 | before(&rows[1], word);
        [left, right, rows[0][word], rows[2][word]]
    }
}

/// The last mark of the stretch before one.
fn before(row: &RowMarks, word: usize) -> u64 {
    word.checked_sub(1)
        .map_or(0, |word| row[word] >> (STRETCH - 1))
}

/// Calls with the number of each bit that is set.
#[inline(always)]
fn each(mut bits: u64, mut call: impl FnMut(usize)) {
    while bits != 0 {
        call(bits.trailing_zeros() as usize % STRETCH);
        bits &= bits - 1;
    }
}

/// Adds the points of a traced batch to the sums of the pixels on both sides, as far as they are in the stretch, which begins at
/// pixel (left, top) and has so many rows, and clears the batch.
fn add_middles([left, top]: [usize; 2], height: usize, worker: &mut Worker) {
    let Worker { batch, middles, .. } = worker;
    let middles = &mut middles[..height];
    for i in 0..batch.points.len() {
        let (x, y) = batch.points.position(i);
        let sample = spread(batch.results.sample(i).0);
        for [x, y] in [
            [x / PARTS, y / PARTS],
            [x.div_ceil(PARTS), y.div_ceil(PARTS)],
        ] {
            // What lies before the stretch wraps around.
            let row = middles.get_mut(y.wrapping_sub(top));
            if let Some(sum) = row.and_then(|row| row.get_mut(x.wrapping_sub(left))) {
                *sum += sample;
            }
        }
    }
    batch.points.clear();
}

/// A point's channels as far apart as a sum has them.
pub(super) fn spread(sample: Sample) -> u64 {
    let channel = |number: usize| (sample.0 >> (16 * number) & 0xffff) << (FIELD * number);
    channel(0) | channel(1) | channel(2)
}

/// A pixel mixed with points beside it, by the sum of these and how many there are to the left, to the right, above and below.
#[inline(never)]
pub(super) fn mixed(pixel: u32, sum: u64, [left, right, above, below]: [usize; 4]) -> u32 {
    // Thirds of the pixel along each axis that has a point; what has none is the pixel's own.
    let thirds = 3 * ((left | right) + (above | below));
    let own = thirds - (left + right + above + below);
    let steps = thirds * STEP as usize;
    let channel = |number: usize| {
        let pixel = (pixel >> (8 * number) & 0xff) as usize * STEP as usize;
        let sum = (sum >> (FIELD * number)) as usize % (1 << FIELD);
        (((pixel * own + sum + steps / 2) / steps) << (8 * number)) as u32
    };
    channel(0) | channel(1) | channel(2)
}
