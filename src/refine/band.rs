//! A band of the picture: the unit of work that threads share.

use super::fill::Canvas;
use super::square::Verdict;
use super::{Border, Square};
use crate::lanes::*;
use crate::prepare::{GroupSet, Prepared};
use crate::quality::Quality;
use crate::trace::{BATCH, trace};
use crate::worker::Worker;

/// Rows of a band, unless its squares are larger: enough for full lanes, few enough to share a picture evenly.
const ROWS: usize = 16;

/// Pixels of a stretch of a band along x, about.
const STRETCH: usize = 256;

/// Splits that a stretch can ask for in one round: all squares of two pixels.
pub(crate) const MAX_SPLITS: usize =
    (STRETCH + Quality::MAX_SQUARE) * Quality::MAX_SQUARE / 4 + STRETCH;

/// Some rows of the picture.
#[derive(Default)]
pub struct Band<'a> {
    /// The picture's rows from here.
    pub(crate) top: usize,
    pub(crate) width: usize,
    pub(crate) pixels: &'a mut [u32],
    /// The borders above and below, or none where points are not shared.
    pub(crate) borders: &'a mut [Border],
    /// Whether the borders hold what the band above and the band below traced.
    pub(crate) above_done: bool,
    pub(crate) below_done: bool,
}

impl Band<'_> {
    /// Rows of a band for squares of a size.
    pub(crate) const fn rows(square: usize) -> usize {
        if square > ROWS {
            square
        } else {
            ROWS / square * square
        }
    }
}

/// Renders a band.
#[inline(always)]
pub(crate) fn render<S: Simd>(
    simd: S,
    scene: &Prepared,
    quality: &Quality,
    worker: &mut Worker,
    band: &mut Band<'_>,
) {
    let height = band.pixels.len() / band.width;
    let mut canvas = Canvas {
        pixels: &mut *band.pixels,
        width: band.width,
        height,
    };
    if quality.square == 1 {
        every_pixel(simd, scene, quality, worker, &mut canvas, band.top);
        return;
    }
    let rows = Band::rows(quality.square);
    let columns = band.width.next_multiple_of(quality.square) + 1;
    worker.points.clear(rows + 1, columns);
    let keys = quality.needs_keys();
    if band.above_done {
        worker.points.row(0).copy(&band.borders[0], columns, keys);
    }
    if band.below_done {
        worker
            .points
            .row(rows)
            .copy(&band.borders[1], columns, keys);
    }
    let mut refiner = Refiner {
        scene,
        quality,
        top: band.top,
        seen: 0,
        above_done: band.above_done,
        below_done: band.below_done,
        worker,
        canvas,
    };
    let stretch = STRETCH / quality.square * quality.square;
    for start in (0..band.width).step_by(stretch) {
        refiner.stretch(simd, start, (start + stretch).min(columns - 1));
    }
    if !band.above_done {
        band.borders[0].copy(worker.points.row(0), columns, keys);
        band.borders[1].copy(worker.points.row(rows), columns, keys);
    }
}

/// Traces every pixel, a stretch at a time.
#[inline(always)]
fn every_pixel<S: Simd>(
    simd: S,
    scene: &Prepared,
    quality: &Quality,
    worker: &mut Worker,
    canvas: &mut Canvas<'_>,
    top: usize,
) {
    let Worker { batch, pixels, .. } = worker;
    let stretch = BATCH / ROWS;
    for start in (0..canvas.width).step_by(stretch) {
        let count = stretch.min(canvas.width - start);
        for y in 0..canvas.height {
            batch.push_run(simd, start, top + y, count);
        }
        let seen = scene.seen(start, top, start + count, top + canvas.height);
        trace(simd, scene, quality, seen, batch);
        batch.pixels(simd, pixels);
        batch.clear();
        let runs = pixels.as_flattened().chunks(count);
        for (y, run) in runs.take(canvas.height).enumerate() {
            canvas.put_run(start, y, run);
        }
    }
}

/// A band at work.
struct Refiner<'a> {
    scene: &'a Prepared,
    quality: &'a Quality,
    top: usize,
    /// The groups that the stretch at work can show.
    seen: GroupSet,
    /// Whether the first and the last row of corners are traced.
    above_done: bool,
    below_done: bool,
    worker: &'a mut Worker,
    canvas: Canvas<'a>,
}

impl Refiner<'_> {
    /// Draws the columns from `start` to `end`, whole squares.
    #[inline(always)]
    fn stretch<S: Simd>(&mut self, simd: S, start: usize, end: usize) {
        let square = self.quality.square;
        let rows = self.canvas.height.next_multiple_of(square);
        self.seen = self.scene.seen(start, self.top, end, self.top + rows);
        for y in (0..=rows).step_by(square) {
            if y == 0 && self.above_done || y == Band::rows(square) && self.below_done {
                continue;
            }
            // The stretch before this one has traced the first column.
            let first = if start == 0 { 0 } else { start + square };
            for x in (first..=end).step_by(square) {
                self.add(simd, x, y);
            }
        }
        self.trace(simd);
        let mut splits = 0;
        for y in (0..rows).step_by(square) {
            for x in (start..end).step_by(square) {
                let side = square as u8;
                let square = Square {
                    x: x as u16,
                    y: y as u16,
                    w: side,
                    h: side,
                };
                self.decide(simd, &square, &mut splits, 0);
            }
        }
        let mut round = 0;
        while splits > 0 {
            self.trace(simd);
            let asked = splits;
            splits = 0;
            for i in 0..asked {
                let square = self.worker.splits[round % 2][i];
                if square.is_last() {
                    self.put_pixels(&square);
                } else {
                    for part in square.parts() {
                        self.decide(simd, &part, &mut splits, round + 1);
                    }
                }
            }
            round += 1;
        }
    }

    /// Fills a square, or asks for the points that its parts need.
    #[inline(always)]
    fn decide<S: Simd>(&mut self, simd: S, square: &Square, splits: &mut usize, round: usize) {
        let (x, y) = (square.x as usize, square.y as usize);
        if square.w == 0 || square.h == 0 || x >= self.canvas.width || y >= self.canvas.height {
            return;
        }
        if square.w == 1 && square.h == 1 {
            let pixel = self.worker.points.sample(x, y).pixel();
            self.canvas.put(x, y, pixel);
            return;
        }
        let corners = square.corners(&self.worker.points);
        match square.verdict(simd, self.quality, &self.worker.points, corners) {
            Verdict::Flat(pixel) => self.canvas.flat(square, pixel),
            Verdict::Bilinear => self.canvas.bilinear(simd, square, corners),
            Verdict::Split => {
                self.worker.splits[round % 2][*splits] = *square;
                *splits += 1;
                self.request_parts(simd, square);
            }
        }
    }

    /// Asks for the points that a square's parts need beyond its own corners.
    #[inline(always)]
    fn request_parts<S: Simd>(&mut self, simd: S, square: &Square) {
        let (x, y) = (square.x as usize, square.y as usize);
        let (right, below) = (x + square.w as usize, y + square.h as usize);
        let (middle_x, middle_y) = square.middle();
        if square.is_last() {
            // Single pixels need no corners but their own point.
            for (x, y) in [(middle_x, y), (x, middle_y), (middle_x, middle_y)] {
                if x < self.canvas.width && y < self.canvas.height {
                    self.request(simd, x, y);
                }
            }
        } else {
            for (x, y) in [
                (middle_x, y),
                (x, middle_y),
                (middle_x, middle_y),
                (right, middle_y),
                (middle_x, below),
            ] {
                self.request(simd, x, y);
            }
        }
    }

    /// Draws the single pixels of a split square.
    #[inline(always)]
    fn put_pixels(&mut self, square: &Square) {
        for y in square.y..square.y + u16::from(square.h) {
            for x in square.x..square.x + u16::from(square.w) {
                let (x, y) = (x as usize, y as usize);
                let pixel = self.worker.points.sample(x, y).pixel();
                self.canvas.put(x, y, pixel);
            }
        }
    }

    /// Asks for a point of the band, unless it has been asked for.
    #[inline(always)]
    fn request<S: Simd>(&mut self, simd: S, x: usize, y: usize) {
        if self.worker.points.claim(x, y) {
            self.add(simd, x, y);
        }
    }

    /// Asks for a point of the band.
    #[inline(always)]
    fn add<S: Simd>(&mut self, simd: S, x: usize, y: usize) {
        if self.worker.batch.is_full() {
            self.trace(simd);
        }
        self.worker.batch.push(x, self.top + y);
    }

    /// Traces the points asked for.
    #[inline(always)]
    fn trace<S: Simd>(&mut self, simd: S) {
        let Worker { batch, points, .. } = &mut *self.worker;
        trace(simd, self.scene, self.quality, self.seen, batch);
        let keys = self.quality.needs_keys();
        for (x, y, sample, key) in batch.results() {
            points.put(x, y - self.top, sample);
            if keys {
                points.put_key(x, y - self.top, key);
            }
        }
        batch.clear();
    }
}
