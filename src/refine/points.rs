//! Which points a level needs, and how they become known: from the level above, as a mean of two, or traced.

use super::TILE_WIDTH;
use super::bits::{Bits, WORDS};
use super::pyramid::Pyramid;
use super::tile::{Marks, Tile};
use super::verdict::Limit;
use super::worker::Worker;
use crate::observe::Observer;
use crate::quality::Quality;
use crate::trace::{BATCH, Counts, trace};

/// Points side by side that are traced before those to the right of them, all rows.
const BLOCK: usize = 16;
const BLOCK_MASK: u64 = (1 << BLOCK) - 1;

impl<O: Observer> Tile<'_, O> {
    /// Finds the points of a level: the corners of all its squares, or the squares themselves where they are pixels.
    pub(super) fn find_points(&mut self, level: usize, is_first: bool) {
        let squares = self.area.rows(level);
        let rows = squares + usize::from(level > 0);
        let parts = self.area.parts(level);
        let limit = Limit::new(self.quality.tolerance_side, self.area.side(level + 1));
        let known_columns = Bits::multiples(parts);
        for y in 0..rows {
            let marks = &self.worker.marks;
            let mut points = corners(&marks.squares[level], level, y, squares);
            if !is_first {
                let known = if y.is_multiple_of(parts) {
                    known_columns
                } else {
                    Bits::NONE
                };
                let must = corners(&marks.open[level], level, y, squares);
                self.take_over(level, y, points & known);
                points = points & !known;
                if parts == 2 && self.quality.tolerance_side > 0.0 {
                    let middles = points & !must;
                    points = points & !self.average(level, y, middles, limit);
                }
            }
            self.worker.marks.traced[level][y] = points;
        }
        self.trace_marked(level, rows);
    }

    /// Traces the points of a level that are marked, block by block: rays of neighbours meet the same objects.
    fn trace_marked(&mut self, level: usize, rows: usize) {
        let side = self.area.side(level);
        for word in 0..WORDS {
            let marked = |marks: &Marks, y: usize| marks.traced[level][y].0[word];
            let marks = &self.worker.marks;
            let any = (0..rows).fold(0, |any, y| any | marked(marks, y));
            for shift in (0..64).step_by(BLOCK) {
                if any >> shift & BLOCK_MASK == 0 {
                    continue;
                }
                for y in 0..rows {
                    let mut rest = marked(&self.worker.marks, y) >> shift & BLOCK_MASK;
                    while rest != 0 {
                        let x = 64 * word + shift + rest.trailing_zeros() as usize;
                        let (x, y) = (self.area.left + x * side, self.area.top + y * side);
                        self.worker.batch.push(x, y);
                        if self.worker.batch.is_full() {
                            self.trace(level);
                        }
                        rest &= rest - 1;
                    }
                }
            }
        }
        self.trace(level);
    }

    /// Takes points over from the level above, where their numbers are divided by a square's parts along a side.
    fn take_over(&mut self, level: usize, y: usize, points: Bits) {
        let has_patterns = self.scene.has_patterns();
        let parts = Divisor::new(self.area.parts(level));
        let row = Pyramid::place(level + 1, 0, parts.divide(y));
        points.for_each(|x| {
            let pyramid = &mut self.worker.pyramid;
            let from = row + parts.divide(x);
            let (sample, key) = (pyramid.sample(from), pyramid.key(from));
            if level == 0 {
                self.canvas.put(self.area.left + x, y, sample.pixel());
                return;
            }
            let to = Pyramid::place(level, x, y);
            pyramid.put(to, sample, key);
            if has_patterns {
                let layers = pyramid.layers(from);
                pyramid.put_layers(to, layers);
            }
        });
    }

    /// Gives the middles of sides the mean of the ends, where these agree and are near enough; says which points.
    fn average(&mut self, level: usize, y: usize, points: Bits, limit: Limit) -> Bits {
        let mut averaged = Bits::NONE;
        // In rows that the level above has, middles lie between two of its columns; else between two rows.
        let (middles, across, down) = if y.is_multiple_of(2) {
            (!Bits::EVEN, 1, 0)
        } else {
            (Bits::EVEN, 0, 1)
        };
        (points & middles).for_each(|x| {
            let pyramid = &mut self.worker.pyramid;
            let from = Pyramid::place(level + 1, x / 2, y / 2);
            let to = Pyramid::place(level + 1, x / 2 + across, y / 2 + down);
            let (a, b) = (pyramid.sample(from), pyramid.sample(to));
            let key = pyramid.key(from);
            // What a pattern leaves at the middle its ends do not tell.
            let is_near =
                key == pyramid.key(to) && limit.has(a, b) && !a.is_patterned() && !b.is_patterned();
            if !is_near {
                return;
            }
            averaged.set(x);
            if level == 0 {
                self.canvas.put(self.area.left + x, y, a.mean(b).pixel());
            } else {
                pyramid.put(Pyramid::place(level, x, y), a.mean(b), key);
            }
        });
        averaged
    }

    /// Traces the points of a level that wait in the batch.
    fn trace(&mut self, level: usize) {
        self.trace_batch();
        let Worker { batch, pyramid, .. } = &mut *self.worker;
        let has_patterns = self.scene.has_patterns();
        let side = Divisor::new(self.area.side(level));
        for i in 0..batch.len() {
            let (x, y, mut sample, key) = batch.result(i);
            let y = y - self.area.top;
            if level == 0 {
                self.canvas.put(x, y, sample.pixel());
                continue;
            }
            let place = Pyramid::place(level, side.divide(x - self.area.left), side.divide(y));
            let has_pattern = |id| self.scene.has_pattern(id);
            if has_patterns && sample.object().is_some_and(has_pattern) {
                sample = sample.patterned();
                pyramid.put_layers(place, batch.layers(i));
            }
            pyramid.put(place, sample, key);
        }
        self.end_batch();
    }

    /// Has the batch traced.
    pub(super) fn trace_batch(&mut self) {
        let batch = &mut self.worker.batch;
        trace(self.isa, self.scene, self.quality, self.seen, batch);
    }

    /// Ends a batch that has been read.
    pub(super) fn end_batch(&mut self) {
        if O::LISTENS {
            self.tell_points();
        }
        self.worker.batch.clear();
    }

    /// Tells the observer of the batch's points. Each is traced once more by itself, to see what it costs; that leaves the
    /// batch's counts as they were.
    fn tell_points(&mut self) {
        let batch = &mut self.worker.batch;
        let mut places = [(0, 0); BATCH];
        let count = batch.len();
        for (i, place) in places[..count].iter_mut().enumerate() {
            let (x, y, ..) = batch.result(i);
            *place = (x, y);
        }
        let counts = batch.counts;
        for &(x, y) in &places[..count] {
            batch.clear();
            batch.counts = Counts::NONE;
            batch.push(x, y);
            trace(self.isa, self.scene, self.quality, self.seen, batch);
            self.observer.point(x, y, batch.counts);
        }
        batch.counts = counts;
    }
}

/// Divides by a side: a multiplication, as points are divided one by one.
#[derive(Clone, Copy)]
pub(super) struct Divisor {
    /// More than `2^16 / side`, by 1 at most.
    inverse: usize,
}

impl Divisor {
    #[inline(always)]
    pub fn new(side: usize) -> Self {
        Self {
            inverse: (1 << 16) / side + 1,
        }
    }

    /// The quotient of a number of pixels, rounded down: exact below 2^16 / [`Quality::MAX_SQUARE`], which is 2,048.
    #[inline(always)]
    pub fn divide(self, pixels: usize) -> usize {
        (pixels * self.inverse) >> 16
    }
}

const _: () = assert!(TILE_WIDTH < (1 << 16) / Quality::MAX_SQUARE);

/// The corners of some rows of squares that lie in row `y` of a level's points; of pixels, the squares of that row.
#[inline(always)]
pub(super) fn corners(squares: &[Bits], level: usize, y: usize, rows: usize) -> Bits {
    let row = |y: usize| if y < rows { squares[y] } else { Bits::NONE };
    if level == 0 {
        return row(y);
    }
    let above = y.checked_sub(1).map_or(Bits::NONE, row);
    (above | row(y)).ends()
}
