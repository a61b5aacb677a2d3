//! Squares of one object with a pattern: light is interpolated, and the pattern is seen at every pixel.
//!
//! A traced point shows `rest + share * full` (see [`Layers`](crate::trace::Layers)). Both layers are interpolated, and the
//! share is what the pattern leaves where the pixel's own ray meets the object, which is known. So edges of a pattern stay as
//! sharp as traced, wherever they run between the corners.

use super::refiner::Refiner;
use super::square::{Corners, Limit, Square};
use crate::lanes::*;
use crate::observe::{Fill, Observer};
use crate::quality::Quality;
use crate::trace::pattern_at_pixels;
use glam::Vec3A;

/// The output's brightest step.
static BRIGHTEST: Vec3A = Vec3A::splat(255.0);

/// Added to a number it leaves the nearest whole one in the low bits.
const ROUND_TO_INTEGER: f32 = (1 << 23) as f32;

impl<S: Simd, O: Observer> Refiner<'_, S, O> {
    /// Fills a square whose corners all show one object with a pattern, unless one of their layers is too far apart; nothing
    /// where they show several.
    #[inline(never)]
    pub(super) fn fill_patterned(
        &mut self,
        square: &Square,
        corners: &Corners,
        limit: Limit,
    ) -> Option<bool> {
        let object = corners[0].object();
        if corners.iter().any(|corner| corner.object() != object) {
            return None;
        }
        let (left, upper, w, h) = square.place();
        let points = &self.worker.points;
        let row = |y| [points.layers(left, y), points.layers(left + w, y)];
        let ([a, b], [c, d]) = (row(upper), row(upper + h));
        let spread = a.max(b).max(c.max(d)) - a.min(b).min(c.min(d));
        let side = w.max(h);
        if spread.most() > limit.steps(side) {
            return Some(false);
        }
        let (across, down) = (1.0 / w as f32, 1.0 / h as f32);
        let (mut first, mut step) = (a, (b - a) * across);
        let (first_down, step_down) = ((c - a) * down, ((d - c) * across - step) * down);
        let canvas = &mut self.canvas;
        let right = (left + w).min(canvas.width);
        let mut shares = [[0.0; 4]; Quality::MAX_SQUARE / 4];
        for y in upper..(upper + h).min(canvas.height) {
            for (x, shares) in steps(left, right, 4).zip(&mut shares) {
                *shares = pattern_at_pixels(self.scene, object - 1, x, self.top + y);
            }
            let row = y * canvas.width;
            let row = canvas.pixels.get_mut(row + left..row + right);
            let mut now = first;
            for (pixel, &share) in row
                .unwrap_or_default()
                .iter_mut()
                .zip(shares.as_flattened())
            {
                let colour = (now.rest + now.full * share).max(Vec3A::ZERO);
                let [blue, green, red] = (colour.min(BRIGHTEST) + ROUND_TO_INTEGER).to_array();
                let byte = |colour: f32| colour.to_bits() & 0xff;
                *pixel = byte(red) << 16 | byte(green) << 8 | byte(blue);
                now = now + step;
            }
            first = first + first_down;
            step = step + step_down;
        }
        // The corner as it was traced, to the last bit.
        let corner = upper * self.canvas.width + left;
        if let Some(pixel) = self.canvas.pixels.get_mut(corner) {
            *pixel = corners[0].pixel();
        }
        self.tell(square, Fill::Patterned);
        Some(true)
    }
}
