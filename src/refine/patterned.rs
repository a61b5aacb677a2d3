//! Squares of one object with a pattern: light is interpolated, and the pattern is seen at every pixel.
//!
//! A traced point shows `rest + share * full` (see [`Layers`]). Both layers are interpolated, and the share is what the pattern
//! leaves where the pixel's own ray meets the object, which is known. So edges of a pattern stay as sharp as traced, wherever
//! they run between the corners.

use super::pyramid::Pyramid;
use super::tile::Tile;
use super::verdict::steps;
use crate::observe::Observer;
use crate::quality::Quality;
use crate::trace::{Layers, pattern_at_pixels};
use glam::Vec3A;

/// The output's brightest step.
const BRIGHTEST: Vec3A = Vec3A::splat(255.0);

impl<O: Observer> Tile<'_, O> {
    /// Fills the square (x, y) of a level, whose corners all show one object with a pattern, unless their layers are too far
    /// apart; says whether they are not.
    pub(super) fn fill_pattern(&mut self, level: usize, [x, y]: [usize; 2], agree: bool) -> bool {
        let side = 1 << level;
        let pyramid = &self.worker.pyramid;
        let (above, below) = (Pyramid::place(level, x, y), Pyramid::place(level, x, y + 1));
        let corners = [above, above + 1, below, below + 1].map(|place| pyramid.layers(place));
        let tolerance = if agree {
            self.quality.tolerance_agreeing
        } else {
            self.quality.tolerance_differing
        };
        if span(&corners) > steps(tolerance, level) {
            return false;
        }
        let corner = pyramid.sample(above);
        let object = corner.object() - 1;
        let (left, top) = (self.area.left + (x << level), y << level);
        let (right, bottom) = (
            self.canvas.width.min(left + side),
            self.canvas.height.min(top + side),
        );
        let [a, b, c, d] = corners;
        let part = 1.0 / side as f32;
        let (mut first, mut step) = (a, (b - a) * part);
        let (first_down, step_down) = ((c - a) * part, ((d - c) * part - step) * part);
        let mut shares = [[0.0; 4]; Quality::MAX_SQUARE / 4];
        for y in top..bottom {
            for (x, shares) in (left..right).step_by(4).zip(&mut shares) {
                *shares = pattern_at_pixels(self.scene, object, x, self.area.top + y);
            }
            let row = y * self.canvas.width;
            let row = &mut self.canvas.pixels[row + left..row + right];
            let mut now = first;
            for (pixel, &share) in row.iter_mut().zip(shares.as_flattened()) {
                *pixel = now.pixel(share);
                now = now + step;
            }
            first = first + first_down;
            step = step + step_down;
        }
        // The corner as it was traced, to the last bit.
        self.canvas.put(left, top, corner.pixel());
        true
    }
}

/// The most that a number of the corners' layers spans, in output steps.
fn span(&[a, b, c, d]: &[Layers; 4]) -> f32 {
    (a.max(b).max(c.max(d)) - a.min(b).min(c.min(d))).most()
}

impl Layers {
    /// The pixel where a pattern leaves a share.
    #[inline(always)]
    fn pixel(self, share: f32) -> u32 {
        let colour = (self.rest + self.full * share).clamp(Vec3A::ZERO, BRIGHTEST);
        let [blue, green, red] = (colour + 0.5).to_array();
        (red as u32) << 16 | (green as u32) << 8 | blue as u32
    }
}
