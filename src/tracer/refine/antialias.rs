//! Antialiasing, the second phase of a frame: pixels at edges are blended with points between them.
//!
//! Where two neighbours differ by an edge, the midpoint between them is traced, once for both. Each pixel bisects its half up to
//! the midpoint: if the pixel and the midpoint differ by [`HALF`], the point between them is traced, and if that differs from
//! either end by [`QUARTER`], one more point on that side; by twice as much, a third.
//!
//! ```text
//!     a          midpoint         b
//!   +---------------+---------------+
//!   |               |     /         |
//!   |       x       o   o/o x       |        a and the midpoint are alike. Between it and b the edge is found to an eighth.
//!   |               |   /           |
//!   +---------------+---------------+
//!                    an edge
//! ```
//!
//! Along each axis, the pixel's colour is the mean of its points by the trapezoid rule: a midpoint at an edge weighs a quarter, and
//! a side without an edge has the pixel's own colour. The axis with the larger change replaces the pixel: the line that crosses the
//! edge steeply measures coverage better than a mean of both. Marks compare pixels as drawn, also across bands, so any number of
//! threads gives the same bits, and even areas keep theirs. A filled square of 8 has no edges inside: only rough cells and the
//! pixels on their borders are searched.

use super::Context;
use super::worker::{Interval, STRETCH, Worker};

use crate::coverage::rectangle;
use crate::grid::{SCRATCH, each};
use crate::lanes::*;
use crate::observe::Observer;
use crate::picture::{
    Band, CELL, CELL_ROWS, MAX_BANDS, MAX_WIDTH, RoughRow, TILE_HEIGHT, TILE_WIDTH,
};
use crate::plan::FramePlan;
use crate::prepare::VisibleGroups;
use crate::quality::Quality;
use crate::trace::{BATCH, PARTS, STEP, Sample};
use core::ops::Range;
use fearless_simd::{u8x16, u8x32, u32x4, u32x8};

/// The least difference of pixel and midpoint that starts the bisection, in units of a sample, is this times [`Quality::edge`].
const HALF: u64 = 2 * STEP as u64;

/// The least difference for the second step is 64/10 times [`Quality::edge`], and twice as much for the third: more than 255 from
/// an edge of 20 on, so there is none.
const QUARTER: u64 = 64 * STEP as u64;

const ROWS: usize = 2;

/// Bisection needs a point on both sides of each midpoint.
const MIDDLES: usize = BATCH / 2;

/// The bits of a channel in a change.
const FIELD: usize = 21;

const SIGN: u64 = 1 << (FIELD - 1);

/// The unit of a change is 1/32 of a sample's: all weights are whole. A change is a word of the pyramid's scratch memory, per pixel and
/// axis: blue, green and red from the low bits up, signed fields of [`FIELD`] bits. A negative field borrows from the next one.
const WEIGHTS: u64 = 2 * PARTS as u64;

type RowMarks = [u64; MAX_STRETCHES];

const MAX_STRETCHES: usize = MAX_WIDTH.div_ceil(STRETCH);

const CELLS: usize = STRETCH / CELL;

/// Marks between each band's last row and the row below, as drawn: the next band may be smoothed already. (Copies of the rows would take 2
/// MB.)
pub(crate) struct Seams([RowMarks; MAX_BANDS]);

impl Seams {
    pub const fn new() -> Self {
        Self([[0; _]; MAX_BANDS])
    }

    /// Computes the marks of a drawn picture.
    pub fn set(&mut self, plan: &FramePlan, picture: &Band<'_>) {
        let finished = plan.finished;
        let &Band { stride, ref pixels, ref rough, .. } = picture;
        let ends = (TILE_HEIGHT * stride..pixels.len()).step_by(TILE_HEIGHT * stride);
        for (number, end) in ends.enumerate() {
            let (above, below) = (&pixels[end - stride..], &pixels[end..]);
            let next = CELL_ROWS * (number + 1);
            let rough = [&rough[next - 1], &rough[next]];
            let words = finished.div_ceil(STRETCH);
            for (word, marks) in self.0[number][..words].iter_mut().enumerate() {
                let stretch = stretch(word, finished);
                let cells = rough_cells(rough[0], word) | rough_cells(rough[1], word);
                *marks = mark(plan, &above[stretch.clone()], &below[stretch], cells);
            }
        }
    }

    pub fn smooth<O: Observer>(
        &self,
        context: &Context<'_, O>,
        worker: &mut Worker,
        band: &mut Band<'_>,
    ) {
        let number = band.top / TILE_HEIGHT;
        let is_last = band.top + band.height() == context.plan.size[1];
        // Pixels on the picture's border have no edge outward.
        let none = &[0; MAX_STRETCHES];
        let above = number.checked_sub(1).map_or(none, |above| &self.0[above]);
        let below = if is_last { none } else { &self.0[number] };
        mix(context, [above, below], worker, band);
    }
}

/// Marks of a stretch: for each row, the edges to the row above and to the right. The last entry is for the row below the band.
type Marks = [u64; ROWS * TILE_HEIGHT + 1];

fn stretch(word: usize, width: usize) -> Range<usize> {
    width.min(word * STRETCH)..width.min((word + 1) * STRETCH)
}

/// Returns a bit for each rough cell of a stretch.
fn rough_cells(row: &RoughRow, word: usize) -> u64 {
    let tile = row[word / (TILE_WIDTH / STRETCH)];
    tile >> (CELLS * word % (TILE_WIDTH / CELL)) & ((1 << CELLS) - 1)
}

/// Marks the edges between two lines of pixels, in the cells whose bits are set.
#[inline(never)]
fn mark(plan: &FramePlan, line: &[u32], other: &[u32], cells: u64) -> u64 {
    let edge = plan.quality.edge;
    let mut marks = 0;
    each(cells, |cell| {
        let (start, end) = (CELL * cell, CELL * (cell + 1));
        marks |= match (line.get(start..end), other.get(start..end)) {
            (Some(a), Some(b)) => edges(edge, a, b) << start,
            _ => {
                let pairs = line.iter().zip(other).enumerate().skip(start);
                pairs.fold(0, |marks, (i, (&a, &b))| marks | u64::from(is_edge(edge, a, b)) << i)
            }
        };
    });
    marks
}

/// Marks the edges of a stretch. The method's overlay, right of the finished columns, is not smoothed.
fn mark_stretch(
    plan: &FramePlan,
    band: &Band<'_>,
    word: usize,
    [above, below]: [&RowMarks; 2],
    marks: &mut Marks,
) {
    let finished = plan.finished;
    let stretch = stretch(word, finished);
    let right = finished.min(stretch.start + 1)..finished.min(stretch.end + 1);
    let rows = band.height();
    let line = |y: usize, part: &Range<usize>| &band.pixels[y * band.stride..][part.clone()];
    marks[0] = above[word];
    for y in 0..rows {
        let rough = &band.rough[y / CELL];
        let here = rough_cells(rough, word);
        // The last pixel of a cell is adjacent to the next cell.
        let next = if word + 1 < MAX_STRETCHES { rough_cells(rough, word + 1) & 1 } else { 0 };
        let adjacent = here | here >> 1 | next << (CELLS - 1);
        marks[ROWS * y + 1] = mark(plan, line(y, &stretch), line(y, &right), adjacent);
        marks[ROWS * y + 2] = if y + 1 < rows {
            let both = here | rough_cells(&band.rough[(y + 1) / CELL], word);
            mark(plan, line(y, &stretch), line(y + 1, &stretch), both)
        } else {
            below[word]
        };
    }
}

#[inline(always)]
fn edges(edge: u8, a: &[u32], b: &[u32]) -> u64 {
    let [a, b]: [u8x32<Baseline>; 2] =
        [a, b].map(|row| u32x8::from_slice(baseline(), row).bitcast());
    let over = (a.max(b) - a.min(b)).saturating_sub(edge - 1);
    let over: u32x8<Baseline> = over.bitcast();
    (!over.simd_eq(0)).to_bitmask()
}

#[inline(never)]
pub(super) fn is_edge(edge: u8, a: u32, b: u32) -> bool {
    let [a, b]: [u8x16<Baseline>; 2] =
        [a, b].map(|pixel| u32x4::splat(baseline(), pixel).bitcast());
    let over = (a.max(b) - a.min(b)).saturating_sub(edge - 1);
    let over: u32x4<Baseline> = over.bitcast();
    over.as_slice()[0] != 0
}

fn mix<O: Observer>(
    context: &Context<'_, O>,
    borders: [&RowMarks; 2],
    worker: &mut Worker,
    band: &mut Band<'_>,
) {
    worker.batch.begin();
    worker.pyramid.scratch().fill(0);
    let &Context { plan, coverage, .. } = context;
    let finished = plan.finished;
    let mut marks: Marks = [0; _];
    // For each row, whether an edge lies between the previous stretch and this one.
    let mut before = [0; TILE_HEIGHT];
    let (top, height) = (band.top, band.height());
    for (word, start) in (0..finished).step_by(STRETCH).enumerate() {
        mark_stretch(plan, band, word, borders, &mut marks);
        let any = marks[..=ROWS * height].iter().chain(&before).fold(0, |all, row| all | row);
        if any == 0 {
            continue;
        }
        let (left, above) = (start.saturating_sub(1), top.saturating_sub(1));
        let rect = rectangle(left, above, start + STRETCH, top + height);
        let seen = coverage.visible_groups(coverage.axes.rect(rect));
        for (number, &row) in marks[..=ROWS * height].iter().enumerate() {
            if row == 0 && (number % ROWS == 0 || before[number / ROWS] == 0) {
                continue;
            }
            if worker.batch.points.len() + STRETCH + 1 > MIDDLES {
                trace_middles(context, seen, start, band, worker);
            }
            let points = &mut worker.batch.points;
            let [x, y] = [ROWS * start + number % ROWS, (ROWS * top + number).wrapping_sub(1)]
                .map(|at| at.wrapping_mul(PARTS / ROWS));
            if number % ROWS != 0 && before[number / ROWS] != 0 {
                points.push(x - PARTS, y);
            }
            each(row, |bit| points.push(x + PARTS * bit, y));
        }
        trace_middles(context, seen, start, band, worker);
        for (y, row) in band.rows() {
            let right = marks[ROWS * y + 1];
            let along_x = right | right << 1 | before[y];
            before[y] = right >> (STRETCH - 1);
            each(along_x | marks[ROWS * y] | marks[ROWS * y + 2], |bit| {
                mix_pixel(&mut row[start + bit], STRETCH * y + bit, worker);
            });
        }
    }
}

/// Traces the batch's midpoints, adds them to the changes of both pixels, within the stretch from column `left`, and bisects.
#[inline(never)]
fn trace_middles<O>(
    context: &Context<'_, O>,
    seen: VisibleGroups,
    left: usize,
    band: &Band<'_>,
    worker: &mut Worker,
) {
    let plan = context.plan;
    context.trace(&plan.quality, seen, &mut worker.batch);
    for i in 0..2 * worker.batch.points.len() {
        let (point, side) = (i / 2, i % 2);
        let (x, y) = worker.batch.points.position(point);
        let axis = usize::from(x % PARTS == 0);
        let [x, y] = [x, y].map(|at| (at + (PARTS - 1) * (1 - side)) / PARTS);
        let (column, row) = (x.wrapping_sub(left), y.wrapping_sub(band.top));
        if column < STRETCH && row < band.height() {
            let drawn = band.pixels[band.stride * row + x];
            let pixel = STRETCH * row + column;
            add_middle(plan, worker, point, drawn, [x, y], pixel, 2 * axis + side);
        }
    }
    worker.batch.points.clear();
    bisect(context, &plan.quality, seen, worker);
}

/// Adds a traced midpoint on one side of a pixel to its changes, and queues the interval if it has an edge.
#[inline(never)]
pub(super) fn add_middle(
    plan: &FramePlan,
    worker: &mut Worker,
    point: usize,
    drawn: u32,
    [x, y]: [usize; 2],
    pixel: usize,
    side: usize,
) {
    let ends = [widened(drawn), spread(worker.batch.results.sample(point))];
    let word = 2 * pixel + side / 2;
    let change = &mut worker.pyramid.scratch()[word % SCRATCH];
    *change = change.wrapping_add(ends[1].wrapping_sub(ends[0]).wrapping_mul(WEIGHTS / 4));
    if contrast(ends) >= HALF * u64::from(plan.quality.edge) {
        worker.intervals[worker.found % BATCH] = Interval {
            ends,
            start: (PARTS * (y << 16 | x)) as u32,
            half: (PARTS / 4) as i16 * (2 * (side % 2) as i16 - 1),
            word: word as u16,
        };
        worker.found += 1;
    }
}

/// Bisects the queued intervals. The batch is empty before and after.
#[inline(never)]
pub(super) fn bisect<O>(
    context: &Context<'_, O>,
    quality: &Quality,
    seen: VisibleGroups,
    worker: &mut Worker,
) {
    while worker.found > 0 {
        let count = core::mem::take(&mut worker.found);
        for i in 0..count {
            let middle = worker.intervals[i % BATCH].middle();
            worker.batch.points.push_at(middle);
        }
        context.trace(quality, seen, &mut worker.batch);
        worker.batch.points.clear();
        for i in 0..count {
            let mut interval = worker.intervals[i % BATCH];
            let [start, end] = interval.ends;
            let middle = spread(worker.batch.results.sample(i));
            // From the mean of two to the mean of three points by the trapezoid rule.
            let more = (2 * middle).wrapping_sub(start + end);
            let weight = u64::from(interval.half.unsigned_abs());
            let change = &mut worker.pyramid.scratch()[usize::from(interval.word) % SCRATCH];
            *change = change.wrapping_add(more.wrapping_mul(weight));
            interval.ends = [start, middle];
            let mut most = contrast(interval.ends);
            let other = contrast([middle, end]);
            if most < other {
                most = other;
                interval.ends = [middle, end];
                interval.start = interval.middle();
            }
            if 5 * most * (weight / 2) >= QUARTER * u64::from(context.plan.quality.edge) {
                interval.half /= 2;
                worker.intervals[worker.found % BATCH] = interval;
                worker.found += 1;
            }
        }
    }
}

#[inline(never)]
fn contrast([a, b]: [u64; 2]) -> u64 {
    let channels = [0, 1, 2].map(|number| channel(a, number).abs_diff(channel(b, number)));
    channels.into_iter().fold(0, u64::max)
}

/// Blue is channel 0.
fn channel(colour: u64, number: usize) -> u64 {
    colour >> (FIELD * number) & ((1 << FIELD) - 1)
}

fn colour(channel: impl Fn(usize) -> u64) -> u64 {
    channel(0) | channel(1) << FIELD | channel(2) << (2 * FIELD)
}

/// Spreads the channels over the fields of a change.
#[inline(never)]
fn spread(sample: Sample) -> u64 {
    colour(|number| sample.0 >> (16 * number) & 0xffff)
}

#[inline(never)]
fn widened(pixel: u32) -> u64 {
    colour(|number| u64::from(pixel >> (8 * number) & 0xff) * STEP as u64)
}

/// Blends a pixel along the axis with the larger change in a channel, and resets both changes.
#[inline(never)]
pub(super) fn mix_pixel(drawn: &mut u32, pixel: usize, worker: &mut Worker) {
    const UNIT: u64 = WEIGHTS * STEP as u64;
    let scratch = worker.pyramid.scratch();
    let [x, y] = [0, 1].map(|axis| core::mem::take(&mut scratch[(2 * pixel + axis) % SCRATCH]));
    let signs = colour(|_| SIGN);
    let [most_x, most_y] = [x, y].map(|change| contrast([change.wrapping_add(signs), signs]));
    let change = if most_x < most_y { y } else { x };
    let sum = WEIGHTS * widened(*drawn) + colour(|_| UNIT / 2);
    let steps = sum.wrapping_add(change) / UNIT;
    let channel = |number: usize| (steps >> ((FIELD - 8) * number)) as u32 & 0xff << (8 * number);
    *drawn = channel(0) | channel(1) | channel(2);
}
