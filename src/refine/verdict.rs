//! What becomes of a square: filled, or split.

use super::Square;
use super::refiner::Refiner;
use super::square::{ALWAYS_FAR, Corners, is_wider};
use crate::lanes::*;
use crate::observe::{Fill, Observer};
use crate::trace::Sample;

impl<S: Simd, O: Observer> Refiner<'_, S, O> {
    /// Looks at the parts of a square: fills them, or lists them for the next round.
    #[inline(never)]
    pub(super) fn look_at(&mut self, square: &Square) {
        if square.is_last() {
            self.put_pixels(square);
            return;
        }
        let grid = square.grid(&self.worker.points);
        let (x, y, w, h) = square.place();
        // Beyond the picture the grid may hold points of other frames.
        let has_grid = x + w <= self.canvas.width && y + h <= self.canvas.height;
        let is_clear = square.is_clear || has_grid && !self.may_hide(square, grid.samples());
        for i in 0..4 {
            let mut part = square.part(i);
            let corners = grid.corners(i);
            let (x, y, w, h) = part.place();
            if x >= self.canvas.width || y >= self.canvas.height {
                continue;
            }
            if w == 0 || h == 0 {
                continue;
            }
            if w == 1 && h == 1 {
                self.put_pixels(&part);
                continue;
            }
            part.is_clear = is_clear || !self.may_hide(&part, &corners);
            if !part.is_clear || !self.fill(&part, corners) {
                self.request_parts(&part, &corners);
                self.list(part);
            }
        }
    }

    /// Fills a square, a part of another, unless its corners are too far apart.
    #[inline(always)]
    fn fill(&mut self, square: &Square, mut corners: Corners) -> bool {
        let mut limit = self.limits.agreeing;
        let needs_keys = self.quality.needs_keys();
        if needs_keys && !square.agrees(&self.worker.points) {
            limit = self.limits.differing;
        }
        if Sample::any_patterned(&corners)
            && let Some(is_filled) = self.fill_patterned(square, &corners, limit)
        {
            return is_filled;
        }
        // By the rules of 2008 nothing is between equal colours.
        if needs_keys && corners.iter().all(|c| c.pixel() == corners[0].pixel()) {
            corners = [corners[0]; 4];
        }
        let (_, _, w, h) = square.place();
        if is_wider(self.simd, &corners, limit.of(w.max(h))) {
            return false;
        }
        let side = self.side();
        self.canvas.fill(self.simd, square, &corners, side);
        if O::LISTENS {
            let is_flat = corners.iter().all(|c| c.pixel() == corners[0].pixel());
            self.tell(square, if is_flat { Fill::Flat } else { Fill::Bilinear });
        }
        true
    }

    /// Tells the observer of a square that has been drawn.
    #[inline(always)]
    pub(super) fn tell(&self, square: &Square, fill: Fill) {
        let (x, y, w, h) = square.place();
        self.observer.square(x, self.top + y, w, h, fill);
    }

    /// Whether there may be an object in a square that none of these samples shows, which are on its sides and inside.
    #[inline(never)]
    fn may_hide(&self, square: &Square, samples: &[Sample]) -> bool {
        let (x, y, w, h) = square.place();
        let rectangle = self.rectangle(x, y, w, h);
        // Points beyond the picture show nothing.
        let is_inside = x + w < self.canvas.width && self.top + y + h < self.scene.height;
        let unseen = &self.worker.unseen;
        unseen.may_show(self.scene, rectangle, samples, is_inside)
    }

    /// Sets the pixels of a square whose points are all known.
    #[inline(always)]
    fn put_pixels(&mut self, square: &Square) {
        self.tell(square, Fill::Points);
        let (x, y, w, h) = square.place();
        for y in y..y + h {
            for x in x..x + w {
                let sample = self.worker.points.sample(x, y);
                self.canvas.put(x, y, sample.pixel());
            }
        }
    }

    /// Asks for the points that a square's parts need beyond its own corners.
    #[inline(always)]
    fn request_parts(&mut self, square: &Square, corners: &Corners) {
        let (x, y, w, h) = square.place();
        let is_last = square.is_last();
        let has_middle = (w | h) % 2 == 0;
        // What a pattern leaves at the middle of a side its ends do not tell.
        let is_patterned = Sample::any_patterned(corners);
        let side_limit = if square.is_clear && has_middle && !is_patterned {
            self.limits.side.of(w.max(h))
        } else {
            ALWAYS_FAR
        };
        // Places in the grid, a digit each from the right: single pixels need the first three, all other parts these five.
        let mut places: u32 = if is_last { 0x431 } else { 0x75431 };
        while places > 0 {
            let place = places as usize % 16;
            places /= 16;
            let (i, j) = (place % 3, place / 3);
            // Not where all parts that would use it are beyond the picture.
            let (u, v) = if is_last { (i, j) } else { (i / 2, j / 2) };
            let is_needed =
                x + u * (w / 2) < self.canvas.width && y + v * (h / 2) < self.canvas.height;
            if is_needed {
                let limit = if place == 4 { ALWAYS_FAR } else { side_limit };
                let (from, to) = (i / 2 + j / 2 * 2, i.div_ceil(2) + j.div_ceil(2) * 2);
                let (from, to) = (corners[from % 4], corners[to % 4]);
                self.request(x + i * w / 2, y + j * h / 2, limit, from, to);
            }
        }
    }
}
