//! A band at work: what is traced when.

use super::fill::Canvas;
use super::square::ALWAYS_FAR;
use super::{Band, Border, Square};
use crate::lanes::*;
use crate::observe::{Observer, tell_points};
use crate::prepare::{Prepared, Seen, rectangle};
use crate::quality::{Limits, Quality};
use crate::trace::{BATCH, Sample, trace};
use crate::worker::Worker;
use fearless_simd::Level;
use glam::Vec4;

/// Rows of a stretch where every pixel is traced, as [`Band::rows`] has it.
const ROWS: usize = 16;

/// Pixels of a stretch of a band along x, about.
const STRETCH: usize = 256;

/// Squares that can wait to be looked at: in each of two rounds all of two pixels' side, and what odd sides leave.
pub(crate) const MAX_SQUARES: usize = 2 * (STRETCH * Quality::MAX_SQUARE / 2);

/// Draws a band.
pub(super) struct Refiner<'a, S: Simd, O: Observer> {
    /// The lanes that squares are looked at in.
    pub simd: S,
    /// The instruction set that rays are traced by.
    pub level: Level,
    pub scene: &'a Prepared,
    pub quality: &'a Quality,
    pub observer: O,
    pub top: usize,
    /// The groups that the stretch at work can show.
    pub seen: Seen,
    pub limits: Limits,
    /// The next square to look at, and the end of those that are listed: they go round in the worker's memory.
    pub next: usize,
    pub end: usize,
    pub worker: &'a mut Worker,
    pub canvas: Canvas<'a>,
}

impl<S: Simd, O: Observer> Refiner<'_, S, O> {
    /// Traces every pixel, a stretch at a time.
    #[inline(always)]
    pub fn every_pixel(&mut self) {
        let (width, height) = (self.canvas.width, self.canvas.height);
        for start in steps(0, width, BATCH / ROWS) {
            let end = (start + BATCH / ROWS).min(width);
            self.seen = self.scene.seen(start, self.top, end, self.top + height);
            for y in self.top..self.top + height {
                for x in start..end {
                    self.worker.batch.push(x, y);
                }
            }
            self.trace_batch();
            let batch = &mut self.worker.batch;
            let rows = self.canvas.pixels.chunks_exact_mut(width.max(1));
            let mut traced = batch.pixels(self.simd).iter();
            for row in rows {
                let pixels = row.get_mut(start..end).unwrap_or_default();
                for (pixel, &traced) in pixels.iter_mut().zip(traced.by_ref()) {
                    *pixel = traced;
                }
            }
            self.end_batch();
        }
    }

    /// Takes over what the neighbours traced, `before` this band's own points, or hands them what they will need.
    #[inline(never)]
    pub fn exchange(&mut self, borders: &mut [Border], are_done: [bool; 2], before: bool) {
        let rows = Band::rows(self.quality.square);
        let columns = self.quality.whole(self.canvas.width) + 1;
        let layers = self.scene.has_patterns();
        let keys = self.quality.needs_keys();
        let points = &mut self.worker.points;
        if before {
            points.clear(rows + 1);
        }
        for (i, (border, is_done)) in borders.iter_mut().zip(are_done).enumerate() {
            let Some(row) = points.row(i * rows) else {
                return;
            };
            if is_done == before {
                let (to, from) = if before { (row, border) } else { (border, row) };
                to.copy(from, columns, layers, keys);
            }
        }
    }

    /// Draws by squares, a stretch at a time.
    #[inline(always)]
    pub fn squares(&mut self) {
        // Whole pairs of squares, since squares start as parts of one twice as large.
        let pair = 2 * self.quality.square;
        let stretch = STRETCH / pair * pair;
        let width = self.quality.whole(self.canvas.width);
        for start in steps(0, width, stretch) {
            self.stretch(start, (start + stretch).min(width));
        }
    }

    /// Draws the columns from `start` to `end`, whole squares.
    #[inline(always)]
    fn stretch(&mut self, start: usize, end: usize) {
        let rows = self.quality.whole(self.canvas.height);
        self.seen = self.scene.seen(start, self.top, end, self.top + rows);
        if self.quality.guarded {
            let rectangle = self.rectangle(start, 0, end - start, rows);
            self.worker
                .unseen
                .set(self.scene, self.seen.directly, rectangle);
        }
        self.first_squares(start, end, rows);
        while self.next != self.end {
            self.trace();
            // Those that are listed from here on need what is not traced yet.
            let end = self.end;
            while self.next != end {
                let square = self.worker.squares[self.next % MAX_SQUARES];
                self.next += 1;
                self.look_at(&square);
            }
        }
    }

    /// Asks for the corners of all squares, and lists squares twice as large, which those are the parts of.
    #[inline(always)]
    fn first_squares(&mut self, start: usize, end: usize, rows: usize) {
        let side = self.quality.square;
        for y in steps(0, rows + 1, side) {
            for x in steps(start, end + 1, side) {
                self.request(x, y, ALWAYS_FAR, Sample::default(), Sample::default());
            }
        }
        let side = 2 * side;
        for y in steps(0, rows, side) {
            for x in steps(start, end, side) {
                self.list(Square {
                    x: x as u16,
                    y: y as u16,
                    w: side as u8,
                    h: side as u8,
                    is_clear: !self.quality.guarded,
                });
            }
        }
    }

    /// Lists a square to be looked at in the next round.
    #[inline(always)]
    pub(super) fn list(&mut self, square: Square) {
        self.worker.squares[self.end % MAX_SQUARES] = square;
        self.end += 1;
    }

    /// Asks for a point, unless that has been done; it is not traced but averaged where it lies between samples that are
    /// not farther apart than a limit for all who ask. (Out of line where bytes count for more than time.)
    #[inline(always)]
    pub(super) fn request(&mut self, x: usize, y: usize, limit: u64, a: Sample, b: Sample) {
        let row = self.worker.points.row(y);
        if !row.is_some_and(|row| row.claim(self.simd, x, limit, a, b)) {
            return;
        }
        self.worker.batch.push(x, self.top + y);
        if self.worker.batch.is_full() {
            self.trace();
        }
    }

    /// Traces the points asked for.
    #[inline(never)]
    fn trace(&mut self) {
        self.trace_batch();
        let Worker { batch, points, .. } = &mut *self.worker;
        let has_patterns = self.scene.has_patterns();
        let keys = self.quality.needs_keys();
        for i in 0..batch.len() {
            let (x, y, mut sample, key) = batch.result(i);
            if let Some(row) = points.row(y - self.top) {
                if has_patterns && self.scene.has_pattern(sample.object() - 1) {
                    sample = sample.patterned();
                    row.put_layers(x, batch.layers(i));
                }
                row.put(x, sample);
                if keys {
                    row.put_key(x, key);
                }
            }
        }
        self.end_batch();
    }

    /// Has the batch traced.
    #[inline(always)]
    fn trace_batch(&mut self) {
        let batch = &mut self.worker.batch;
        trace(self.level, self.scene, self.quality, self.seen, batch);
    }

    /// Tells of a batch that has been read, and begins the next one.
    #[inline(always)]
    fn end_batch(&mut self) {
        let batch = &mut self.worker.batch;
        tell_points(
            self.observer,
            self.level,
            self.scene,
            self.quality,
            self.seen,
            batch,
        );
        batch.clear();
    }

    /// The corners of a rectangle of points in the picture.
    #[inline(always)]
    pub(super) fn rectangle(&self, x: usize, y: usize, w: usize, h: usize) -> Vec4 {
        let y = self.top + y;
        rectangle(x, y, x + w, y + h)
    }
}
