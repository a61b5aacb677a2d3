//! Squares that are filled by light, a pixel at a time: those of one object with a pattern, where the light is interpolated and
//! the pattern is seen at every pixel, and those whose side is no power of two.
//!
//! A traced point shows `rest + share * untextured` (see [`Layers`]). Both layers are interpolated, and the share is what the pattern
//! leaves where the pixel's own ray meets the object, which is known. So edges of a pattern stay as sharp as traced, wherever
//! they run between the corners.

use super::pyramid::Pyramid;
use super::tile::Tile;
use super::verdict::{Verdict, steps};
use crate::lanes::*;
use crate::observe::Observer;
use crate::prepare::{Film, ObjectId};
use crate::quality::Quality;
use crate::trace::{Layers, STEP, Sample, pattern_at_pixels};
use fearless_simd::f32x4;
use glam::Vec3A;

/// The output's brightest step.
const BRIGHTEST: Vec3A = Vec3A::splat(255.0);

impl<O: Observer> Tile<'_, O> {
    /// Fills the square (x, y) of a level, whose corners all show one object with a pattern, unless their layers are too far
    /// apart; says whether they are not.
    pub(super) fn fill_pattern(&mut self, level: usize, [x, y]: [usize; 2], agree: bool) -> bool {
        let side = self.area.side(level);
        let pyramid = &self.worker.pyramid;
        let indices = Pyramid::corner_indices(level, x, y);
        let corners = indices.map(|index| pyramid.layers(index));
        let tolerance = if agree {
            self.quality.tolerance_agreeing
        } else {
            self.quality.tolerance_differing
        };
        if span(&corners) > steps(tolerance, side) {
            return false;
        }
        let corner = pyramid.sample(indices[0]);
        self.interpolate(level, [x, y], corners, corner.object());
        // The corner as it was traced, to the last bit.
        let (left, top) = (self.area.left + x * side, y * side);
        self.put(left, top, corner);
        true
    }

    /// Fills the squares of a row that passed the verdict, whatever their side is.
    pub(super) fn fill_any(&mut self, level: usize, y: usize, verdict: &Verdict) {
        verdict.filled.for_each(|x| {
            let mut corners = self.worker.pyramid.corners(level, x, y);
            if verdict.flat.has(x) {
                corners = [corners[0]; 4];
            }
            self.interpolate(level, [x, y], corners.map(Layers::of), None);
        });
    }

    /// Interpolates the corners' layers along both sides of the square (x, y) of a level, as far as it is in the picture. Where
    /// an object is given, its pattern is seen at every pixel.
    #[inline(never)]
    fn interpolate(
        &mut self,
        level: usize,
        [x, y]: [usize; 2],
        [a, b, c, d]: [Layers; 4],
        object: Option<ObjectId>,
    ) {
        let side = self.area.side(level);
        let (left, top) = (self.area.left + x * side, y * side);
        let (right, bottom) = (
            self.canvas.width.min(left + side),
            self.canvas.height.min(top + side),
        );
        let part = 1.0 / side as f32;
        let (mut first, mut step) = (a, (b - a) * part);
        let (first_down, step_down) = ((c - a) * part, ((d - c) * part - step) * part);
        let mut shares = [[0.0; 4]; Quality::MAX_SQUARE / 4];
        for y in top..bottom {
            if let Some(object) = object {
                for (x, shares) in (left..right).step_by(4).zip(&mut shares) {
                    *shares = pattern_at_pixels(self.scene, object, x, self.area.top + y);
                }
            }
            let row = y * self.canvas.width;
            let row = &mut self.canvas.pixels[row + left..row + right];
            let mut now = first;
            let shares = shares.as_flattened();
            for (x, (pixel, &share)) in (left..).zip(row.iter_mut().zip(shares)) {
                let mut colour = now.rest + now.untextured * share;
                if object.is_some() {
                    // Samples are exposed, layers are not.
                    colour = expose(&self.scene.film, colour, x, self.area.top + y);
                }
                let threshold = self.scene.film.threshold(x, self.area.top + y);
                *pixel = cut(colour + (threshold & 0xff) as f32 / STEP as f32);
                now = now + step;
            }
            first = first + first_down;
            step = step + step_down;
        }
    }
}

/// The most that a number of the corners' layers spans, in output steps.
fn span(&[a, b, c, d]: &[Layers; 4]) -> f32 {
    (a.max(b).max(c.max(d)) - a.min(b).min(c.min(d))).most()
}

impl Layers {
    /// A sample's colour, without a pattern.
    fn of(sample: Sample) -> Self {
        let channel = |shift: u32| (sample.0 >> shift & 0xffff) as f32 / STEP as f32;
        Self {
            rest: Vec3A::new(channel(0), channel(16), channel(32)),
            untextured: Vec3A::ZERO,
        }
    }
}

/// The colour that light becomes at the pixel (x, y).
#[inline(always)]
fn expose(film: &Film, light: Vec3A, x: usize, y: usize) -> Vec3A {
    let simd = baseline();
    let at = [x, y].map(|c| f32x4::splat(simd, c as f32));
    let dimming: [f32; 4] = film.dimming(at).into();
    let light = light.extend(0.0).to_array().simd_into(simd);
    let [blue, green, red, _] = film.expose(simd, light, dimming[0]).into();
    Vec3A::new(blue, green, red)
}

/// The pixel of a colour in output steps, without its fraction.
#[inline(always)]
fn cut(colour: Vec3A) -> u32 {
    let [blue, green, red] = colour.clamp(Vec3A::ZERO, BRIGHTEST).to_array();
    (red as u32) << 16 | (green as u32) << 8 | blue as u32
}
