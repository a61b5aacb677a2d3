//! A band of the picture: the unit of work that threads share.

use super::fill::Canvas;
use super::square::{self, Corners, Spreads, Verdict};
use super::{Border, Square};
use crate::lanes::*;
use crate::observe::{Fill, Observer, tell_points};
use crate::prepare::{Prepared, Seen};
use crate::quality::Quality;
use crate::scene::camera::pixels;
use crate::trace::{BATCH, Sample, trace};
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
        seen: Seen::default(),
        next: 0,
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
    seen: Seen,
    /// Squares listed for the next round.
    next: usize,
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
            let pixels = batch.pixels(self.simd);
            for y in 0..height {
                let pixels = &pixels[y * count..];
                for (to, &pixel) in self.canvas.row(start, y, count).iter_mut().zip(pixels) {
                    *to = pixel;
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
        if self.quality.guarded {
            let rectangle = self.rectangle(start, 0, end - start, rows);
            self.worker
                .unseen
                .set(self.simd, self.scene, self.seen.directly, rectangle);
        }
        self.add_corners(start, end, rows);
        let mut count = self.first_squares(start, end, rows);
        let mut round = 0;
        while count > 0 {
            self.trace();
            self.next = 0;
            for i in 0..count {
                let square = self.worker.squares[round][i];
                if square.is_last() {
                    self.put_pixels(&square);
                } else {
                    self.look_at(&square, 1 - round);
                }
            }
            round = 1 - round;
            count = self.next;
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
                    is_clear: !self.quality.guarded,
                };
                count += 1;
            }
        }
        count
    }

    /// Looks at the parts of a square: fills them, or lists them for the next round.
    #[inline(always)]
    fn look_at(&mut self, square: &Square, next_round: usize) {
        let grid = square.grid(&self.worker.points);
        let (right, below) = (
            square.x + u16::from(square.w),
            square.y + u16::from(square.h),
        );
        // Beyond the picture the grid may hold points of other frames.
        let has_grid = right as usize <= self.canvas.width && below as usize <= self.canvas.height;
        let is_clear = square.is_clear || has_grid && !self.may_hide(square, grid.samples());
        let largest = square.w.max(square.h);
        let spreads = grid.spreads(self.simd, self.quality, largest - largest / 2);
        for i in 0..4 {
            let mut part = square.part(i);
            let corners = grid.corners(i);
            if part.x as usize >= self.canvas.width
                || part.y as usize >= self.canvas.height
                || part.w == 0
                || part.h == 0
            {
                continue;
            }
            if part.w == 1 && part.h == 1 {
                self.put_pixels(&part);
                continue;
            }
            part.is_clear = is_clear || !self.may_hide(&part, &corners);
            if self.decide(&part, i, corners, &spreads) {
                self.request_parts(&part, corners);
                self.worker.squares[next_round][self.next] = part;
                self.next += 1;
            }
        }
    }

    /// Fills a square, part number `i` of another, unless it has to be split.
    #[inline(always)]
    fn decide(&mut self, square: &Square, i: usize, corners: Corners, spreads: &Spreads) -> bool {
        if !square.is_clear {
            return true;
        }
        let agrees = !self.quality.needs_keys() || square.agrees(&self.worker.points);
        match spreads.verdict(i, agrees, corners) {
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

    /// Whether there may be an object in a square that none of these samples shows, which are on its sides and inside.
    #[inline(always)]
    fn may_hide(&self, square: &Square, samples: &[Sample]) -> bool {
        let (x, y) = (square.x as usize, square.y as usize);
        let (w, h) = (square.w as usize, square.h as usize);
        let rectangle = self.rectangle(x, y, w, h);
        // Points beyond the picture show nothing.
        let is_inside = x + w < self.canvas.width && self.top + y + h < self.scene.height;
        let unseen = &self.worker.unseen;
        unseen.may_show(self.simd, self.scene, rectangle, samples, is_inside)
    }

    /// The corners of a rectangle of points in the picture.
    #[inline(always)]
    fn rectangle(&self, x: usize, y: usize, w: usize, h: usize) -> [f32; 4] {
        let y = self.top + y;
        [pixels(x), pixels(y), pixels(x + w), pixels(y + h)]
    }

    /// Sets the pixels of a square whose points are all known.
    #[inline(never)]
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

    /// Asks for the points that a square's parts need beyond its own corners.
    #[inline(always)]
    fn request_parts(&mut self, square: &Square, corners: Corners) {
        let (x, y) = (square.x as usize, square.y as usize);
        let (right, below) = (x + square.w as usize, y + square.h as usize);
        let (middle_x, middle_y) = square.middle();
        let [a, b, c, d] = corners;
        let limit = if square.is_clear {
            self.quality.side_limit(square.w, square.h)
        } else {
            -1.0
        };
        let far = square::far_sides(self.simd, corners, limit);
        // Parts beyond the picture need no corners, and single pixels none but their own point.
        let right_part = middle_x < self.canvas.width;
        let lower_part = middle_y < self.canvas.height;
        let is_last = square.is_last();
        if right_part || !is_last {
            self.request(middle_x, y, far & 0xf == 0, a, b);
        }
        if lower_part || !is_last {
            self.request(x, middle_y, far & 0xf0 == 0, a, c);
        }
        if right_part && lower_part || !is_last {
            self.request(middle_x, middle_y, false, a, d);
        }
        if right_part && !is_last {
            self.request(right, middle_y, far & 0xf00 == 0, b, d);
        }
        if lower_part && !is_last {
            self.request(middle_x, below, far & 0xf000 == 0, c, d);
        }
    }

    /// Asks for a point, unless that has been done; `is_mean` says that it lies between samples that are close enough.
    #[inline(never)]
    fn request(&mut self, x: usize, y: usize, is_mean: bool, a: Sample, b: Sample) {
        if self.worker.points.claim(x, y) {
            if is_mean {
                self.worker.points.put(x, y, a.mean(b));
            } else {
                self.add(x, y);
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
