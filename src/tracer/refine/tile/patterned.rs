//! Squares of one patterned object. A traced point is `rest + share * untextured` (see [`Layers`]).
//! Both layers are interpolated; the share is the pattern's factor at the hit of each pixel's ray.
//! So the pattern's edges are as sharp as traced ones.

use super::state::Tile;
use crate::grid::{Bits, Pyramid};
use crate::lanes::*;
use crate::maths::to_f32;
use crate::observe::Observer;
use crate::picture::Band;
use crate::prepare::{Colours, ObjectId, World};
use crate::refine::Kernels;
use crate::refine::verdict::Verdict;
use crate::trace::{Layers, PatternOnScreen, STEP, Sample};
use fearless_simd::{f32x4, f32x8, i16x8, i32x4, u16x8, u32x4};

impl<O: Observer> Tile<'_, '_, O> {
    /// Fills the squares of a row that show one patterned object with layers within the tolerance,
    /// and returns them. Removes all squares of a patterned object from the verdict.
    pub(super) fn fill_patterned(&mut self, level: usize, y: usize, verdict: &mut Verdict) -> Bits {
        let mut filled = Bits::NONE;
        verdict.patterned.for_each(|x| {
            let pyramid = &self.worker.pyramid;
            let indices = Pyramid::corner_indices(level, x, y);
            let samples = indices.map(|index| pyramid.sample(index));
            let [corner, ..] = samples;
            let Some(object) = patterned_object(&samples) else {
                return;
            };
            verdict.filled.clear(x);
            let layers = indices.map(|index| pyramid.layers[index]);
            let quality = &self.context.plan.quality;
            let tolerance = if verdict.agreeing.has(x) {
                quality.tolerance_agreeing
            } else {
                quality.tolerance_differing
            };
            // Larger squares are split: the kernel evaluates at most 8x8 pixels.
            if level > 3 || span(&layers) > tolerance * self.growth(level) {
                return;
            }
            let [left, top] = [self.area.left + (x << level), y << level];
            let (world, band) = (self.context.world, &mut *self.band);
            let kernels = &self.context.kernels;
            interpolate(kernels, world, band, 1 << level, [left, top], layers, object);
            // The traced corner keeps its exact bits.
            self.put(left, top, corner);
            filled.set(x);
        });
        filled
    }
}

/// Returns the object at all corners, if its pattern is fine at any.
pub(super) fn patterned_object(corners: &[Sample; 4]) -> Option<ObjectId> {
    let object = corners[0].object()?;
    let is_alike = corners.iter().all(|other| other.object() == Some(object));
    (is_alike && corners.iter().any(|it| it.is_patterned())).then_some(object)
}

/// Interpolates the corners' layers over the square at (left, top) of the band.
#[inline(never)]
fn interpolate(
    kernels: &Kernels,
    world: World<'_>,
    band: &mut Band<'_>,
    side: usize,
    [left, top]: [usize; 2],
    corners: [Layers; 4],
    object: ObjectId,
) {
    let simd = baseline();
    let film = &world.film;
    let (right, bottom) = (band.width.min(left + side), band.height().min(top + side));
    let part = 1.0 / to_f32(side);
    let [a, b, c, d] = corners.map(|layers| f32x8::simd_from(simd, layers));
    let (mut first, mut step) = (a, (b - a) * part);
    let (first_down, step_down) = ((c - a) * part, ((d - c) * part - step) * part);
    let pattern = PatternOnScreen::new(world, object);
    let columns = f32x4::simd_from(simd, [0.0, 1.0, 2.0, 3.0]);
    let mut shares = [0.0; 64];
    (kernels.pattern)(kernels.level, &pattern, [left, band.top + top], side, &mut shares);
    for y in top..bottom {
        let row = y * band.stride;
        let row = &mut band.pixels[row + left..row + right];
        let shares = shares[(y - top) * side..].windows(4).step_by(4);
        let y = band.top + y;
        let thresholds = film.thresholds(simd, left, y);
        let mut now = first;
        for ((x, pixels), shares) in (left..).step_by(4).zip(row.chunks_mut(4)).zip(shares) {
            let mut four = [0, 1, 2, 3].map(|i| {
                let (rest, untextured) = now.split();
                now += step;
                rest + untextured * shares[i]
            });
            if !film.is_plain {
                let at = [columns + to_f32(x), splat(simd, to_f32(y))];
                film.expose(&mut four, at);
            }
            let four = rounded(simd, four, thresholds);
            match pixels.first_chunk_mut() {
                Some(pixels) => *pixels = four,
                None => pixels.copy_from_slice(&four[..pixels.len()]),
            }
        }
        first += first_down;
        step += step_down;
    }
}

fn span(corners: &[Layers; 4]) -> f32 {
    let [a, b, c, d] = corners.map(|layers| f32x8::simd_from(baseline(), layers));
    let span: [f32; 8] = (a.max(b).max(c.max(d)) - a.min(b).min(c.min(d))).into();
    span.into_iter().fold(0.0, f32::max)
}

/// Converts four colours to pixels, with thresholds for rounding. Words are 128ths of an output
/// step.
#[inline(always)]
fn rounded(simd: Baseline, colours: Colours, [first, last]: [u16x8<Baseline>; 2]) -> [u32; 4] {
    let max = splat(simd, (255 * STEP) as f32);
    let [a, b, c, d] = colours
        .map(|colour| at_most::<Baseline>(colour * STEP as f32, max).to_int::<i32x4<Baseline>>());
    let steps = |a: i32x4<Baseline>, b, threshold| {
        let words = a.saturating_narrow(b).max(i16x8::splat(simd, 0));
        (words.bitcast::<u16x8<Baseline>>() + threshold) >> STEP.trailing_zeros()
    };
    let bytes = steps(a, b, first).relaxed_narrow(steps(c, d, last));
    (bytes.bitcast::<u32x4<Baseline>>() & 0x00ff_ffff).into()
}
