//! A band of the picture: the unit of work that threads share.

use super::fill::Canvas;
use super::square::{self, Corners, Verdict};
use super::{Border, Square};
use crate::lanes::*;
use crate::observe::{Fill, Observer, tell_points};
use crate::prepare::{GroupSet, Prepared};
use crate::quality::Quality;
use crate::trace::{BATCH, trace};
use crate::worker::Worker;
use fearless_simd::Level;

/// Rows of a band, unless its squares are larger: enough for full lanes, few enough to share a picture evenly.
const ROWS: usize = 16;

/// Pixels of a stretch of a band along x, about.
const STRETCH: usize = 256;

/// Squares that a round can split: all of two pixels' side, and what odd sides leave.
pub(crate) const MAX_SQUARES: usize = STRETCH * Quality::MAX_SQUARE / 2;

/// Some rows of the picture.
#[derive(Default)]
pub struct Band<'a> {
    /// The picture's rows from here.
    pub(crate) top: usize,
    pub(crate) width: usize,
    pub(crate) pixels: &'a mut [u32],
    /// The borders above and below.
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

/// Renders a band: refines in the lanes that every CPU has, traces by the given instruction set.
pub(crate) fn render(
    level: Level,
    scene: &Prepared,
    quality: &Quality,
    worker: &mut Worker,
    band: &mut Band<'_>,
) {
    render_observed(level, scene, quality, (), worker, band);
}

/// Like [`render`], and the observer hears of it.
pub(crate) fn render_observed<O: Observer>(
    level: Level,
    scene: &Prepared,
    quality: &Quality,
    observer: O,
    worker: &mut Worker,
    band: &mut Band<'_>,
) {
    #[cfg(target_arch = "x86_64")]
    if let Some(simd) = level.as_sse2() {
        render_by(simd, level, scene, quality, observer, worker, band);
    }
    #[cfg(not(target_arch = "x86_64"))]
    fearless_simd::dispatch!(level, simd => render_by(simd, level, scene, quality, observer, worker, band));
}

fn render_by<S: Simd, O: Observer>(
    simd: S,
    level: Level,
    scene: &Prepared,
    quality: &Quality,
    observer: O,
    worker: &mut Worker,
    band: &mut Band<'_>,
) {
    let height = band.pixels.len() / band.width;
    let canvas = Canvas {
        pixels: &mut *band.pixels,
        width: band.width,
        height,
    };
    let mut refiner = Refiner {
        simd,
        level,
        scene,
        quality,
        observer,
        top: band.top,
        above_done: band.above_done,
        below_done: band.below_done,
        seen: 0,
        worker,
        canvas,
    };
    if quality.square == 1 {
        refiner.every_pixel();
    } else {
        refiner.squares(band.borders);
    }
}

/// A band at work.
struct Refiner<'a, S: Simd, O: Observer> {
    /// The lanes that squares are looked at in.
    simd: S,
    /// The instruction set that rays are traced by.
    level: Level,
    scene: &'a Prepared,
    quality: &'a Quality,
    observer: O,
    top: usize,
    /// Whether the first and the last row of corners are traced.
    above_done: bool,
    below_done: bool,
    /// The groups that the stretch at work can show.
    seen: GroupSet,
    worker: &'a mut Worker,
    canvas: Canvas<'a>,
}

impl<S: Simd, O: Observer> Refiner<'_, S, O> {
    /// Traces every pixel, a stretch at a time.
    #[inline(always)]
    fn every_pixel(&mut self) {
        let stretch = BATCH / ROWS;
        let (width, height) = (self.canvas.width, self.canvas.height);
        for start in steps(0, width, stretch) {
            let count = stretch.min(width - start);
            self.seen = self
                .scene
                .seen(start, self.top, start + count, self.top + height);
            let batch = &mut self.worker.batch;
            for y in 0..height {
                batch.push_row(start, self.top + y, count);
            }
            trace(self.level, self.scene, self.quality, self.seen, batch);
            for y in 0..height {
                let row = self.canvas.row(start, y, count);
                for (pixel, sample) in row.iter_mut().zip(batch.samples(y * count)) {
                    *pixel = sample.pixel();
                }
            }
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
    }

    /// Draws by squares, a stretch at a time. The borders hold what the neighbours traced, or take what they will need.
    #[inline(always)]
    fn squares(&mut self, borders: &mut [Border]) {
        let square = self.quality.square;
        let rows = Band::rows(square);
        let columns = self.canvas.width.next_multiple_of(square) + 1;
        let keys = self.quality.needs_keys();
        let points = &mut self.worker.points;
        points.clear(rows + 1, columns);
        if self.above_done {
            points.row(0).copy(&borders[0], columns, keys);
        }
        if self.below_done {
            points.row(rows).copy(&borders[1], columns, keys);
        }
        // Whole pairs of squares, since squares start as parts of one twice as large.
        let stretch = STRETCH / (2 * square) * (2 * square);
        for start in steps(0, self.canvas.width, stretch) {
            self.stretch(start, (start + stretch).min(columns - 1));
        }
        if !self.above_done {
            let points = &mut self.worker.points;
            borders[0].copy(points.row(0), columns, keys);
            borders[1].copy(points.row(rows), columns, keys);
        }
    }

    /// Draws the columns from `start` to `end`, whole squares.
    #[inline(always)]
    fn stretch(&mut self, start: usize, end: usize) {
        let rows = self.canvas.height.next_multiple_of(self.quality.square);
        self.seen = self.scene.seen(start, self.top, end, self.top + rows);
        self.add_corners(start, end, rows);
        let mut count = self.first_squares(start, end, rows);
        let mut round = 0;
        while count > 0 {
            self.trace();
            let mut splits = 0;
            for i in 0..count {
                let square = self.worker.squares[round][i];
                if square.is_last() {
                    self.put_pixels(&square);
                    continue;
                }
                let grid = square.grid(&self.worker.points);
                let spreads = grid.spreads(self.simd);
                let parts = square.parts();
                for (part, (corners, &spread)) in
                    parts.iter().zip(grid.corners().into_iter().zip(&spreads))
                {
                    if self.decide(part, corners, spread) {
                        self.request_parts(part, corners);
                        self.worker.squares[1 - round][splits] = *part;
                        splits += 1;
                    }
                }
            }
            round = 1 - round;
            count = splits;
        }
    }

    /// Asks for the corners of all squares.
    #[inline(always)]
    fn add_corners(&mut self, start: usize, end: usize, rows: usize) {
        let square = self.quality.square;
        for y in steps(0, rows + 1, square) {
            let is_done = y == 0 && self.above_done || y == Band::rows(square) && self.below_done;
            // The stretch before this one has traced the first column.
            let first = start + square * usize::from(start > 0);
            for x in steps(first, end + 1, square) {
                if !is_done {
                    self.add(x, y);
                }
            }
        }
    }

    /// Lists squares twice as large as the first ones, which are their parts; says how many.
    #[inline(always)]
    fn first_squares(&mut self, start: usize, end: usize, rows: usize) -> usize {
        let side = 2 * self.quality.square;
        let mut count = 0;
        for y in steps(0, rows, side) {
            for x in steps(start, end, side) {
                let (w, h) = (side as u8, side as u8);
                self.worker.squares[0][count] = Square {
                    x: x as u16,
                    y: y as u16,
                    w,
                    h,
                };
                count += 1;
            }
        }
        count
    }

    /// Sets the pixels of a square that is split into single ones.
    #[inline(always)]
    fn put_pixels(&mut self, square: &Square) {
        self.tell(square, Fill::Points);
        for y in square.y..square.y + u16::from(square.h) {
            for x in square.x..square.x + u16::from(square.w) {
                let (x, y) = (x as usize, y as usize);
                self.canvas
                    .put(x, y, self.worker.points.sample(x, y).pixel());
            }
        }
    }

    /// Fills a square, unless it has to be split or is not in the picture.
    #[inline(always)]
    fn decide(&mut self, square: &Square, corners: Corners, spread: u16) -> bool {
        let (x, y) = (square.x as usize, square.y as usize);
        if x >= self.canvas.width || y >= self.canvas.height || square.w == 0 || square.h == 0 {
            return false;
        }
        if square.w == 1 && square.h == 1 {
            self.put_pixels(square);
            return false;
        }
        match square.verdict(self.quality, &self.worker.points, corners, spread) {
            Verdict::Flat(pixel) => {
                self.canvas.flat(self.simd, square, pixel);
                self.tell(square, Fill::Flat);
            }
            Verdict::Bilinear => {
                self.canvas.bilinear(self.simd, square, corners);
                self.tell(square, Fill::Bilinear);
            }
            Verdict::Split => return true,
        }
        false
    }

    /// Tells the observer of a square that has been drawn.
    #[inline(always)]
    fn tell(&self, square: &Square, fill: Fill) {
        let (x, y) = (square.x as usize, square.y as usize);
        let (w, h) = (square.w as usize, square.h as usize);
        self.observer.square(x, self.top + y, w, h, fill);
    }

    /// Asks for the points that a square's parts need beyond its own corners.
    #[inline(always)]
    fn request_parts(&mut self, square: &Square, corners: Corners) {
        let (x, y) = (square.x as usize, square.y as usize);
        let (right, below) = (x + square.w as usize, y + square.h as usize);
        let (middle_x, middle_y) = square.middle();
        let [a, b, c, d] = corners;
        let limit = self.quality.side_limit(square.w, square.h);
        let close = square::close_sides(self.simd, corners, limit);
        let points = [
            (middle_x, y, close[0].then(|| a.mean(b))),
            (x, middle_y, close[1].then(|| a.mean(c))),
            (middle_x, middle_y, None),
            (right, middle_y, close[2].then(|| b.mean(d))),
            (middle_x, below, close[3].then(|| c.mean(d))),
        ];
        // Parts beyond the picture need no corners, and single pixels none but their own point.
        let right_part = middle_x < self.canvas.width;
        let lower_part = middle_y < self.canvas.height;
        let wanted = if square.is_last() {
            [
                right_part,
                lower_part,
                right_part && lower_part,
                false,
                false,
            ]
        } else {
            [true, true, true, right_part, lower_part]
        };
        for ((x, y, mean), wanted) in points.into_iter().zip(wanted) {
            if wanted && self.worker.points.claim(x, y) {
                match mean {
                    Some(sample) => self.worker.points.put(x, y, sample),
                    None => self.add(x, y),
                }
            }
        }
    }

    /// Asks for a point of the band.
    #[inline(always)]
    fn add(&mut self, x: usize, y: usize) {
        self.worker.batch.push(x, self.top + y);
        if self.worker.batch.is_full() {
            self.trace();
        }
    }

    /// Traces the points asked for.
    #[inline(never)]
    fn trace(&mut self) {
        let Worker { batch, points, .. } = &mut *self.worker;
        trace(self.level, self.scene, self.quality, self.seen, batch);
        let keys = self.quality.needs_keys();
        for i in 0..batch.len() {
            let (x, y, sample, key) = batch.result(i);
            points.put(x, y - self.top, sample);
            if keys {
                points.put_key(x, y - self.top, key);
            }
        }
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
}
