//! Probes compare pixels of a finished band with the same pixels of an exhaustive frame.
//!
//! An antialiased probe also traces its neighbours and the points at edges to them, with the
//! arithmetic of `antialias`: probes of an exhaustive frame find no error.

use super::antialias::is_edge;
use super::bisect::{add_middle, bisect, mix_pixel};
use super::{Context, Worker};
use crate::counts::Counts;
use crate::picture::{Band, CELL, Probing};
use crate::plan::FramePlan;
use crate::prepare::{Film, GroupSet, VisibleGroups};
use crate::quality::Quality;
use crate::trace::{BATCH, Batch, PARTS};

/// The golden ratio as an odd fraction of 2^32.
const GOLDEN: u32 = 0x9e37_79b9;

const BACK: usize = usize::MAX;

/// Left, right, up, down.
const SIDES: [[usize; 2]; 4] = [[BACK, 0], [1, 0], [0, BACK], [0, 1]];

const POINTS: usize = 1 + 2 * SIDES.len();

/// The most probes of a batch; a power of two bounds an index.
const MAX_PROBES: usize = (BATCH / POINTS).next_power_of_two();

/// Returns the probed pixels. Successive seeds visit all pixels in one random order, `count` per
/// seed, then start again.
fn places(probing: Probing, [columns, rows]: [usize; 2]) -> impl Iterator<Item = [usize; 2]> {
    let pixels = (columns * rows) as u32;
    let count = u32::from(probing.count);
    let first = probing.seed.wrapping_mul(count);
    (0..count).map(move |i| {
        let place = shuffled(first.wrapping_add(i) % pixels, pixels) as usize;
        [place % columns, place / columns]
    })
}

/// Returns element `index` of a random permutation of the numbers below `count`.
fn shuffled(mut index: u32, count: u32) -> u32 {
    // Permutes the numbers below a power of two, and skips those from `count` on.
    let mask = count.next_power_of_two() - 1;
    loop {
        for _ in 0..3 {
            index = index.wrapping_mul(GOLDEN).wrapping_add(GOLDEN) & mask;
            index ^= index >> 7;
        }
        if index < count {
            return index;
        }
    }
}

/// Does not count its work.
pub(crate) fn probe<O>(context: &Context<'_, O>, worker: &mut Worker, band: &mut Band<'_>) {
    let Context { plan, world, .. } = context;
    let size = [plan.finished, plan.size[1]];
    if plan.probing.count == 0 || size[0] == 0 || plan.coarse >= 2 {
        return;
    }
    // Probes are far apart: culling groups would not pay.
    let all = VisibleGroups { directly: GroupSet::MAX, mirrored: GroupSet::MAX };
    let sides = if plan.quality.antialias { &SIDES[..] } else { &[] };
    // The index of a pixel in the band. It is beyond the end for pixels of other rows; above, it
    // wraps around.
    let (top, stride) = (band.top, band.stride);
    let index = |[x, y]: [usize; 2]| y.wrapping_sub(top).wrapping_mul(stride).wrapping_add(x);
    let count = band.pixels.len();
    // A fold copies other pixels later.
    let is_drawn = |[x, y]: [usize; 2]| x / CELL >= plan.fold.start(y / CELL, 0);
    let mut places =
        places(plan.probing, size).filter(|&place| index(place) < count && is_drawn(place));
    worker.batch.begin();
    worker.pyramid.changes().fill(0);
    // The probes' indices in the band, and their traced pixels.
    let mut pixels = [(0, 0); MAX_PROBES];
    loop {
        let mut probes = 0;
        for place in places.by_ref().take(BATCH / POINTS) {
            push(&mut worker.batch, size, place, sides);
            pixels[probes % MAX_PROBES].0 = index(place);
            probes += 1;
        }
        if probes == 0 {
            break;
        }
        // Edges are antialiased below, as in the frame.
        let quality = &Quality::EXHAUSTIVE;
        context.trace(quality, all, &mut worker.batch);
        for probe in 0..probes {
            pixels[probe % MAX_PROBES].1 = add_sides(plan, &world.film, worker, probe, sides.len());
        }
        worker.batch.points.clear();
        bisect(context, quality, all, worker);
        for probe in 0..probes {
            let (index, traced) = &mut pixels[probe % MAX_PROBES];
            mix_pixel(traced, probe, worker);
            band.counts.probes.compare(band.pixels[*index], *traced);
        }
    }
    worker.batch.counts = Counts::NONE;
}

#[inline(always)]
fn push(batch: &mut Batch, size: [usize; 2], place: [usize; 2], sides: &[[usize; 2]]) {
    let [x, y] = place;
    batch.points.push_pixel(x, y);
    for step in sides {
        // A pixel on the picture's border is its own neighbour, without an edge.
        let neighbour = [0, 1].map(|i| {
            let neighbour = place[i].wrapping_add(step[i]);
            if neighbour < size[i] { neighbour } else { place[i] }
        });
        let [x, y] = [x + neighbour[0], y + neighbour[1]].map(|at| PARTS / 2 * at);
        batch.points.push(x, y);
        batch.points.push_pixel(neighbour[0], neighbour[1]);
    }
}

#[inline(never)]
fn own(film: &Film, batch: &Batch, point: usize) -> u32 {
    let (x, y) = batch.points.pixel(point);
    batch.results.sample(point).pixel(film.threshold(x, y))
}

/// Returns a probe's pixel before antialiasing, and adds the midpoints at its edges.
fn add_sides(
    plan: &FramePlan,
    film: &Film,
    worker: &mut Worker,
    probe: usize,
    sides: usize,
) -> u32 {
    let first = probe * (1 + 2 * sides);
    let pixel = own(film, &worker.batch, first);
    let (x, y) = worker.batch.points.pixel(first);
    for side in 0..sides {
        let middle = first + 1 + 2 * side;
        if is_edge(plan.quality.edge, pixel, own(film, &worker.batch, middle + 1)) {
            add_middle(plan, worker, middle, pixel, [x, y], probe, side);
        }
    }
    pixel
}
