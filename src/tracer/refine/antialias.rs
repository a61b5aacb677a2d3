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
//! too, so that a picture has the same bits for any number of threads, and what is all alike keeps its bits. Where a square of 8 was
//! filled by colours between its corners' no pixel differs from the next by an edge, so that only the other blocks are looked at, and
//! the pixels on their borders.
//!
//! A thing that is smaller than a pixel and lies between the samples of its neighbours is not found by this: a pixel is looked at
//! more closely only where something can be seen.

use super::worker::{STRETCH, Worker};
use crate::MAX_WIDTH;
use crate::coverage::rectangle;
use crate::grid::each;
use crate::lanes::*;
use crate::observe::Observer;
use crate::picture::{BLOCK, BLOCK_ROWS, Band, MAX_BANDS, RoughRow, TILE_HEIGHT, TILE_WIDTH};
use crate::plan::Context;
use crate::trace::{BATCH, PARTS, STEP, Sample};
use core::ops::Range;
use fearless_simd::{u8x32, u32x8};

/// The least difference of neighbours, in a channel and 255ths, that is an edge.
pub(super) const EDGE: u8 = 20;

/// Bits of a channel in a sum of points: enough for the four beside a pixel.
const FIELD: usize = 21;

/// A bit for each pixel of a row, number 0 in the lowest bit of the first word: whether it differs from a certain neighbour.
type RowMarks = [u64; MAX_STRETCHES];

/// Stretches of the widest row.
const MAX_STRETCHES: usize = MAX_WIDTH.div_ceil(STRETCH);

/// Blocks of a stretch.
const BLOCKS: usize = STRETCH / BLOCK;

/// Where a band's last row differs from the row below it, the first of the next band, as both were drawn.
///
/// By the time that a band is looked at again, its neighbours may have been already. (Bits: the rows themselves would take 2 MB.)
pub(crate) struct Seams([RowMarks; MAX_BANDS]);

impl Seams {
    /// Of no frame.
    pub const fn new() -> Self {
        Self([[0; _]; MAX_BANDS])
    }

    /// Takes in a picture that is drawn, of whose columns so many are finished, one at least.
    pub fn set(&mut self, picture: &Band<'_>, finished: usize) {
        let &Band {
            stride,
            ref pixels,
            ref rough,
            ..
        } = picture;
        // The last band has none below it.
        let ends = (TILE_HEIGHT * stride..pixels.len()).step_by(TILE_HEIGHT * stride);
        for (number, end) in ends.enumerate() {
            let (above, below) = (&pixels[end - stride..], &pixels[end..]);
            let next = BLOCK_ROWS * (number + 1);
            let rough = [&rough[next - 1], &rough[next]];
            let words = finished.div_ceil(STRETCH);
            for (word, marks) in self.0[number][..words].iter_mut().enumerate() {
                let stretch = stretch(word, finished);
                let blocks = blocks(rough[0], word) | blocks(rough[1], word);
                *marks = mark(&above[stretch.clone()], &below[stretch], blocks);
            }
        }
    }

    /// The second phase of a frame: smooths the edges of a band.
    pub fn smooth<O: Observer>(
        &self,
        context: &Context<'_, O>,
        worker: &mut Worker,
        band: &mut Band<'_>,
    ) {
        let number = band.top / TILE_HEIGHT;
        let is_last = band.top + band.height() == context.plan.size[1];
        // Beyond the picture's edge all is alike.
        let none = &[0; MAX_STRETCHES];
        let above = number.checked_sub(1).map_or(none, |above| &self.0[above]);
        let below = if is_last { none } else { &self.0[number] };
        mix(context, [above, below], worker, band);
    }
}

/// Where the pixels of a stretch of a band differ from their neighbours.
///
/// Each row has two: from the one above, and from the one to the right. The last are those of the row below the band from the one
/// above it.
type Marks = [u64; PARTS * TILE_HEIGHT + 1];

/// The pixels of a stretch in a row of so many.
fn stretch(word: usize, width: usize) -> Range<usize> {
    width.min(word * STRETCH)..width.min((word + 1) * STRETCH)
}

/// Which of a stretch's blocks are rough.
fn blocks(row: &RoughRow, word: usize) -> u64 {
    let tile = row[word / (TILE_WIDTH / STRETCH)];
    tile >> (BLOCKS * word % (TILE_WIDTH / BLOCK)) & ((1 << BLOCKS) - 1)
}

/// Marks where a line of pixels of a stretch differs by an edge from another one, as far as this goes, in those of its blocks that
/// are given.
#[inline(never)]
fn mark(line: &[u32], other: &[u32], blocks: u64) -> u64 {
    let mut marks = 0;
    each(blocks, |block| {
        let (start, end) = (BLOCK * block, BLOCK * (block + 1));
        marks |= match (line.get(start..end), other.get(start..end)) {
            (Some(a), Some(b)) => edges(a, b) << start,
            // The last block, which is cut off.
            _ => {
                let pairs = line.iter().zip(other).enumerate().skip(start);
                pairs.fold(0, |marks, (i, (&a, &b))| {
                    marks | u64::from(is_edge(a, b)) << i
                })
            }
        };
    });
    marks
}

/// Marks where the finished pixels of a stretch differ from their neighbours: marks of the method are no edges.
fn mark_stretch(
    band: &Band<'_>,
    finished: usize,
    word: usize,
    [above, below]: [&RowMarks; 2],
    marks: &mut Marks,
) {
    let stretch = stretch(word, finished);
    let right = finished.min(stretch.start + 1)..finished.min(stretch.end + 1);
    let rows = band.height();
    let line = |y: usize| &band.pixels[y * band.stride..][..finished];
    marks[0] = above[word];
    for y in 0..rows {
        let rough = &band.rough[y / BLOCK];
        let here = blocks(rough, word);
        // The last pixel of each block lies beside the first of the next.
        let next = if word + 1 < MAX_STRETCHES {
            blocks(rough, word + 1) & 1
        } else {
            0
        };
        let beside = here | here >> 1 | next << (BLOCKS - 1);
        marks[PARTS * y + 1] = mark(&line(y)[stretch.clone()], &line(y)[right.clone()], beside);
        marks[PARTS * y + 2] = if y + 1 < rows {
            let both = here | blocks(&band.rough[(y + 1) / BLOCK], word);
            mark(
                &line(y)[stretch.clone()],
                &line(y + 1)[stretch.clone()],
                both,
            )
        } else {
            below[word]
        };
    }
}

/// Which of a block's pixels in a row differ from as many others by an edge.
#[inline(always)]
fn edges(a: &[u32], b: &[u32]) -> u64 {
    let [a, b]: [u8x32<Baseline>; 2] =
        [a, b].map(|row| u32x8::from_slice(baseline(), row).bitcast());
    let over = (a.max(b) - a.min(b)).saturating_sub(EDGE - 1);
    let over: u32x8<Baseline> = over.bitcast();
    (!over.simd_eq(0)).to_bitmask()
}

/// Whether two pixels differ by an edge.
pub(super) fn is_edge(a: u32, b: u32) -> bool {
    let mut channels = a.to_le_bytes().into_iter().zip(b.to_le_bytes());
    channels.any(|(a, b)| a.abs_diff(b) >= EDGE)
}

/// Traces the points between a band's pixels that differ, and mixes them.
fn mix<O: Observer>(
    context: &Context<'_, O>,
    borders: [&RowMarks; 2],
    worker: &mut Worker,
    band: &mut Band<'_>,
) {
    worker.batch.begin();
    let &Context { plan, coverage, .. } = context;
    let finished = plan.finished;
    let mut marks: Marks = [0; _];
    // For each row, whether the last pixel of the stretch before differs from the first of this one.
    let mut before = [0; TILE_HEIGHT];
    let (top, height) = (band.top, band.height());
    for (word, start) in (0..finished).step_by(STRETCH).enumerate() {
        // Mark the points between pixels that differ, of a stretch.
        mark_stretch(band, finished, word, borders, &mut marks);
        let any = marks[..=PARTS * height]
            .iter()
            .chain(&before)
            .fold(0, |all, row| all | row);
        if any == 0 {
            continue;
        }
        // Points lie up to half a pixel outside.
        let (left, above) = (start.saturating_sub(1), top.saturating_sub(1));
        let rect = rectangle(left, above, start + STRETCH, top + height);
        let seen = coverage.visible_groups(coverage.axes.rect(rect));
        let traced = |worker: &mut Worker| {
            context.trace(&plan.quality, seen, &mut worker.batch);
            add_middles([start, top], height, worker);
        };
        // Trace them, batch by batch.
        for (number, &row) in marks[..=PARTS * height].iter().enumerate() {
            if row == 0 && (number % PARTS == 0 || before[number / PARTS] == 0) {
                continue;
            }
            if worker.batch.points.len() + STRETCH + 1 > BATCH {
                traced(worker);
            }
            let points = &mut worker.batch.points;
            let (x, y) = (
                PARTS * start + number % PARTS,
                (PARTS * top + number).wrapping_sub(1),
            );
            // Between the last pixel of the stretch before and the first of this one.
            if number % PARTS != 0 && before[number / PARTS] != 0 {
                points.push(x - PARTS, y);
            }
            each(row, |bit| points.push(x + PARTS * bit, y));
        }
        traced(worker);
        // Mix each pixel with the points on its four sides.
        for (y, row) in band.rows() {
            let right = marks[PARTS * y + 1];
            let sides = [
                right << 1 | before[y],
                right,
                marks[PARTS * y],
                marks[PARTS * y + 2],
            ];
            before[y] = right >> (STRETCH - 1);
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

/// Adds the points of a traced batch to the sums of the pixels on both sides, as far as they are in the stretch, which begins at
/// pixel (left, top) and has so many rows, and clears the batch.
fn add_middles([left, top]: [usize; 2], height: usize, worker: &mut Worker) {
    let Worker { batch, middles, .. } = worker;
    let middles = &mut middles[..height];
    for i in 0..batch.points.len() {
        let (x, y) = batch.points.position(i);
        let sample = spread(batch.results.sample(i));
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
    // Divided by 3 or 6 output steps: exact below 2^20.
    const STEPS: u64 = 3 * STEP as u64;
    let (half, inverse) = if thirds == 3 {
        (STEPS / 2, (1 << 40) / STEPS + 1)
    } else {
        (STEPS, (1 << 40) / (2 * STEPS) + 1)
    };
    let channel = |number: usize| {
        let pixel = u64::from(pixel >> (8 * number) & 0xff) * STEP as u64;
        let sum = sum >> (FIELD * number) & ((1 << FIELD) - 1);
        ((((pixel * own as u64 + sum + half) * inverse) >> 40) << (8 * number)) as u32
    };
    channel(0) | channel(1) | channel(2)
}
