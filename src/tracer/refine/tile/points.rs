//! Finds a level's points and their samples: from the level above, by averaging two points, or by
//! tracing.

use super::state::Tile;
use crate::counts::Counts;
use crate::grid::{Bits, Pyramid, WORDS};
use crate::lanes::*;
use crate::observe::Observer;
use crate::refine::Context;
use crate::refine::verdict::Limit;
use crate::refine::worker::{CLUSTER_HEIGHT, CLUSTER_WIDTH, Worker};
use crate::trace::BATCH;
use core::array;
use fearless_simd::f32x8;

const CLUSTER_MASK: u64 = (1 << CLUSTER_WIDTH) - 1;

impl<O: Observer> Tile<'_, '_, O> {
    pub(super) fn find_points(&mut self, level: usize, is_first: bool) {
        let quality = &self.context.plan.quality;
        let squares = self.area.rows(level);
        let rows = squares + usize::from(level > 0);
        let limit = Limit::new(quality.tolerance_side * self.growth(level + 1));
        for y in 0..rows {
            let marks = &self.worker.marks;
            let mut points = corners(&marks.squares[level], level, y, squares);
            if !is_first && !points.is_empty() {
                let known = if y.is_multiple_of(2) { Bits::EVEN } else { Bits::NONE };
                self.copy_known(level, y, points & known);
                points = points.without(known);
                if quality.tolerance_side > 0.0 {
                    let open = &self.worker.marks.open[level];
                    let middles = points.without(corners(open, level, y, squares));
                    points = points.without(self.average(level, y, middles, limit));
                }
            }
            self.worker.marks.traced[level][y] = points;
        }
        self.worker.marks.traced[level][rows..rows.next_multiple_of(CLUSTER_HEIGHT)]
            .fill(Bits::NONE);
        self.trace_marked(level, rows);
    }

    fn trace_marked(&mut self, level: usize, rows: usize) {
        // A row has one more point than squares; pixels fill whole words.
        let used = (self.area.columns(level) / 64 + 1).min(WORDS);
        for top in (0..rows).step_by(CLUSTER_HEIGHT) {
            for word in 0..used {
                // Word by word: mapping the rows would copy them whole.
                let rows = &self.worker.marks.traced[level][top..top + CLUSTER_HEIGHT];
                let words: [u64; CLUSTER_HEIGHT] = array::from_fn(|y| rows[y].0[word]);
                let mut columns = words.iter().fold(0, |all, word| all | word);
                while columns != 0 {
                    let x = columns.trailing_zeros() as usize / CLUSTER_WIDTH * CLUSTER_WIDTH;
                    columns &= !(CLUSTER_MASK << x);
                    let mut cluster = 0;
                    for row in words.iter().rev() {
                        cluster = cluster << CLUSTER_WIDTH | row >> x & CLUSTER_MASK;
                    }
                    self.add_cluster(level, [64 * word + x, top], cluster);
                }
            }
        }
        self.trace(level);
    }

    #[inline(never)]
    pub(super) fn add_cluster(&mut self, level: usize, [left, top]: [usize; 2], mut cluster: u64) {
        if self.worker.batch.points.len() + CLUSTER_WIDTH * CLUSTER_HEIGHT > BATCH {
            self.trace(level);
        }
        let (left, top) = (self.area.left + (left << level), self.area.top + (top << level));
        let points = &mut self.worker.batch.points;
        while cluster != 0 {
            let i = cluster.trailing_zeros() as usize;
            let (x, y) = (i % CLUSTER_WIDTH, i / CLUSTER_WIDTH);
            points.push_pixel(left + (x << level), top + (y << level));
            cluster &= cluster - 1;
        }
    }

    /// Copies points from the level above, at half their coordinates.
    fn copy_known(&mut self, level: usize, y: usize, points: Bits) {
        let has_patterns = self.context.world.has_patterns;
        let row = Pyramid::index(level + 1, 0, y / 2);
        points.for_each(|x| {
            let pyramid = &mut self.worker.pyramid;
            let from = row + x / 2;
            let (sample, key) = (pyramid.sample(from), pyramid.keys[from]);
            if level == 0 {
                self.put(self.area.left + x, y, sample);
                return;
            }
            let to = Pyramid::index(level, x, y);
            pyramid.put(to, sample, key);
            if has_patterns {
                pyramid.layers[to] = pyramid.layers[from];
            }
        });
    }

    /// Sets midpoints of sides to the mean of their ends, and returns those whose ends agree within
    /// the limit.
    fn average(&mut self, level: usize, y: usize, points: Bits, limit: Limit) -> Bits {
        let mut averaged = Bits::NONE;
        // Midpoints are between two columns of the level above in even rows, between two rows in
        // odd rows.
        let (middles, step) = if y.is_multiple_of(2) {
            (Bits::ODD, 1)
        } else {
            (Bits::EVEN, Pyramid::stride(level + 1))
        };
        let start = Pyramid::index(level + 1, 0, y / 2);
        let has_patterns = self.context.world.has_patterns;
        (points & middles).for_each(|x| {
            let pyramid = &mut self.worker.pyramid;
            let ends = [start + x / 2, start + x / 2 + step];
            let (a, b) = (pyramid.sample(ends[0]), pyramid.sample(ends[1]));
            let key = pyramid.keys[ends[0]];
            // The ends do not determine a pattern at the midpoint.
            let is_patterned = a.is_patterned() | b.is_patterned();
            let is_near = (key == pyramid.keys[ends[1]]) & limit.has(a, b) & !is_patterned;
            // Branch-free: the outcome is unpredictable. Tracing overwrites rejected means.
            averaged.0[x / 64] |= u64::from(is_near) << (x % 64);
            if level == 0 {
                self.put(self.area.left + x, y, a.mean(b));
            } else {
                let to = Pyramid::index(level, x, y);
                pyramid.put(to, a.mean(b), key);
                if has_patterns {
                    let [a, b] = ends.map(|i| f32x8::simd_from(baseline(), pyramid.layers[i]));
                    pyramid.layers[to] = ((a + b) * 0.5).into();
                }
            }
        });
        averaged
    }

    pub(super) fn trace(&mut self, level: usize) {
        let Context { plan, world, .. } = self.context;
        let batch = &mut self.worker.batch;
        self.context.trace(&plan.quality, self.visible, batch);
        let Worker { batch, pyramid, .. } = &mut *self.worker;
        let has_patterns = world.has_patterns;
        for i in 0..batch.points.len() {
            let mut sample = batch.results.sample(i);
            let (x, y) = batch.points.pixel(i);
            let (column, row) = (x - self.area.left, y - self.area.top);
            if level == 0 {
                self.band.pixels[row * self.band.stride + x] =
                    sample.pixel(world.film.threshold(x, y));
                continue;
            }
            let target = Pyramid::index(level, column >> level, row >> level);
            let shows = |which: &[bool]| sample.object().is_some_and(|id| which[id.index()]);
            let mut key = batch.results.key(i);
            if plan.quality.crowds && shows(&world.glitters) {
                key = (y << 16 | x) as u32;
            }
            if has_patterns {
                pyramid.layers[target] = batch.results.layers(i, &world.film);
                if batch.results.is_fine(i) {
                    sample = sample.patterned();
                }
            }
            pyramid.put(target, sample, key);
        }
        if O::LISTENS {
            self.report_points();
        }
        self.worker.batch.points.clear();
    }

    /// Traces each point of the batch again to report its rays, without counting them.
    fn report_points(&mut self) {
        let batch = &mut self.worker.batch;
        let mut pixels = [(0, 0); BATCH];
        let count = batch.points.len();
        for (i, pixel) in pixels[..count].iter_mut().enumerate() {
            *pixel = batch.points.pixel(i);
        }
        let counts = batch.counts;
        for &(x, y) in &pixels[..count] {
            batch.points.clear();
            batch.counts = Counts::NONE;
            batch.points.push_pixel(x, y);
            let quality = &self.context.plan.quality;
            self.context.trace(quality, self.visible, batch);
            self.context.observer.point(x, y, batch.counts);
        }
        batch.counts = counts;
    }
}

/// Returns the points of row `y` that are corners of squares; at level 0 the squares themselves.
pub(in crate::refine) fn corners(squares: &[Bits], level: usize, y: usize, rows: usize) -> Bits {
    let row = |y: usize| if y < rows { squares[y] } else { Bits::NONE };
    if level == 0 {
        return row(y);
    }
    let above = y.checked_sub(1).map_or(Bits::NONE, row);
    (above | row(y)).ends()
}
