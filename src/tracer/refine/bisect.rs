//! Bisection at edges, see `antialias`.

use super::Context;
use super::worker::{Interval, Worker};
use crate::grid::CHANGES;
use crate::plan::FramePlan;
use crate::prepare::VisibleGroups;
use crate::quality::Quality;
use crate::trace::{BATCH, PARTS, STEP, Sample};

/// The bisection starts if pixel and midpoint differ by this times [`Quality::edge`] or more, in a
/// sample's units.
const HALF: u64 = 2 * STEP as u64;

/// The second step needs a difference of 6.4 times [`Quality::edge`], the third of 12.8 times, in
/// output steps. With an edge of 20 or more there is no third step.
const QUARTER: u64 = 64 * STEP as u64;

/// The bits of a channel in a change.
const CHANNEL_BITS: usize = 21;

const SIGN: u64 = 1 << (CHANNEL_BITS - 1);

/// The number of a change's units in a sample's unit: all weights are whole. `Pyramid::changes` has
/// a word per pixel and axis: blue, green and red from the low bits up, signed numbers of
/// [`CHANNEL_BITS`] bits. A negative one borrows from the next.
const WEIGHTS: u64 = 2 * PARTS as u64;

/// Adds a midpoint on one side of a pixel to the pixel's changes, and queues the interval if it has
/// an edge.
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
    let ends = [widened_pixel(drawn), widened_sample(worker.batch.results.sample(point))];
    let word = 2 * pixel + side / 2;
    let change = &mut worker.pyramid.changes()[word % CHANGES];
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
    visible: VisibleGroups,
    worker: &mut Worker,
) {
    while worker.found > 0 {
        let count = core::mem::take(&mut worker.found);
        for i in 0..count {
            let middle = worker.intervals[i % BATCH].middle();
            worker.batch.points.push_at(middle);
        }
        context.trace(quality, visible, &mut worker.batch);
        worker.batch.points.clear();
        for i in 0..count {
            halve(worker, i, context.plan.quality.edge);
        }
    }
}

/// Adds the traced middle of interval `i` to the pixel's change, and queues the half with more
/// contrast if it has an edge.
fn halve(worker: &mut Worker, i: usize, edge: u8) {
    let mut interval = worker.intervals[i % BATCH];
    let [start, end] = interval.ends;
    let middle = widened_sample(worker.batch.results.sample(i));
    // Replace the mean of two points by the mean of three, by the trapezoid rule.
    let more = (2 * middle).wrapping_sub(start + end);
    let weight = u64::from(interval.half.unsigned_abs());
    let change = &mut worker.pyramid.changes()[usize::from(interval.word) % CHANGES];
    *change = change.wrapping_add(more.wrapping_mul(weight));
    interval.ends = [start, middle];
    let mut max = contrast(interval.ends);
    let other = contrast([middle, end]);
    if max < other {
        max = other;
        interval.ends = [middle, end];
        interval.start = interval.middle();
    }
    if 5 * max * (weight / 2) >= QUARTER * u64::from(edge) {
        interval.half /= 2;
        worker.intervals[worker.found % BATCH] = interval;
        worker.found += 1;
    }
}

/// Blends a pixel along the axis with the larger change in a channel, and resets both changes.
#[inline(never)]
pub(super) fn mix_pixel(drawn: &mut u32, pixel: usize, worker: &mut Worker) {
    const UNIT: u64 = WEIGHTS * STEP as u64;
    let changes = worker.pyramid.changes();
    let [x, y] = [0, 1].map(|axis| core::mem::take(&mut changes[(2 * pixel + axis) % CHANGES]));
    let signs = colour(|_| SIGN);
    let [max_x, max_y] = [x, y].map(|change| contrast([change.wrapping_add(signs), signs]));
    let change = if max_x < max_y { y } else { x };
    let sum = WEIGHTS * widened_pixel(*drawn) + colour(|_| UNIT / 2);
    let steps = sum.wrapping_add(change) / UNIT;
    let channel = |i: usize| (steps >> ((CHANNEL_BITS - 8) * i)) as u32 & 0xff << (8 * i);
    *drawn = channel(0) | channel(1) | channel(2);
}

#[inline(never)]
fn contrast([a, b]: [u64; 2]) -> u64 {
    let channels = [0, 1, 2].map(|number| channel(a, number).abs_diff(channel(b, number)));
    channels.into_iter().fold(0, u64::max)
}

/// Blue is channel 0.
fn channel(colour: u64, number: usize) -> u64 {
    colour >> (CHANNEL_BITS * number) & ((1 << CHANNEL_BITS) - 1)
}

fn colour(channel: impl Fn(usize) -> u64) -> u64 {
    channel(0) | channel(1) << CHANNEL_BITS | channel(2) << (2 * CHANNEL_BITS)
}

/// Widens the channels to [`CHANNEL_BITS`].
#[inline(never)]
fn widened_sample(sample: Sample) -> u64 {
    colour(|number| sample.0 >> (16 * number) & 0xffff)
}

#[inline(never)]
fn widened_pixel(pixel: u32) -> u64 {
    colour(|number| u64::from(pixel >> (8 * number) & 0xff) * STEP as u64)
}
