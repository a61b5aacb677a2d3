use crate::arguments::{Size, processors};
use crate::error::{Difference, worst_channel};
use crate::flip::{Flip, Flips};
use crate::interrupt;

use crate::missed::Visible;
use crate::picture::Mean;
use crate::technique::Technique;
use crate::threaded_renderer::ThreadedRenderer;
use eightfold_tracer::scene::Scene;
use eightfold_tracer::{Level, Quality};
use rayon::prelude::*;

const GRID: usize = 8;
/// A pixel pops if a channel changes by more than this in one frame, in 255ths,
const POP: u32 = 16;
/// while the reference changes by at most this.
const STILL: u32 = 4;

#[derive(Clone, Default)]
pub struct Seen {
    /// To the reference.
    pub flips: Flips,
    pops: usize,
    pairs: usize,
    missed: usize,
    differences_to_64: Vec<Difference>,
    pub flips_to_64: Flips,
}

impl Seen {
    pub fn pops(&self) -> Option<f64> {
        (self.pairs > 0).then(|| self.pops as f64 / self.pairs as f64)
    }

    pub fn missed(&self) -> Option<f64> {
        let views = self.differences_to_64.len();
        (views > 0).then(|| self.missed as f64 / views as f64)
    }

    pub fn psnr_to_64_db(&self) -> Option<f64> {
        let differences = &self.differences_to_64;
        (!differences.is_empty()).then(|| Difference::pooled_psnr(differences))
    }
}

pub fn pops(references: [&[u32]; 2], frames: [&[u32]; 2]) -> usize {
    let change = |[before, after]: [&[u32]; 2], i: usize| worst_channel(before[i], after[i]);
    let pops = |&i: &usize| change(frames, i) > POP && change(references, i) <= STILL;
    (0..frames[0].len()).filter(pops).count()
}

/// Adds the errors of a view with consecutive frames of `scenes`. The first technique is the reference.
pub fn look(
    techniques: &[Technique],
    level: Level,
    size: Size,
    scenes: &[Scene],
    seen: &mut [Seen],
) {
    let width = size.width;
    let draw = |technique: &Technique, scene: &Scene, renderer: &mut ThreadedRenderer| {
        let mut pixels = vec![0; size.area()];
        technique.draw(renderer, level, scene, width, &mut pixels);
        pixels
    };
    let mut renderer = ThreadedRenderer::new(processors());
    let references = scenes.iter();
    let references = references.map(|scene| draw(&techniques[0], scene, &mut renderer));
    let references: Vec<Vec<u32>> = references.collect();
    let samples = sampled(&mut renderer, level, size, &scenes[0]);
    let visible = Visible::new(&scenes[0], width, size.height);
    let each = techniques.par_iter().zip(seen);
    each.for_each_init(
        || ThreadedRenderer::new(1),
        |renderer, (technique, seen)| {
            let mut before: Vec<u32> = Vec::new();
            for (i, scene) in scenes.iter().enumerate() {
                if interrupt::is_stopped() {
                    return;
                }
                let now = draw(technique, scene, renderer);
                if i > 0 {
                    let references = [&references[i - 1][..], &references[i]];
                    seen.pops += pops(references, [&before, &now]);
                    seen.pairs += 1;
                } else {
                    seen.missed += visible.missed(&references[0], &now);
                    seen.flips.add(&Flip::between(width, &references[0], &now));
                    seen.flips_to_64.add(&Flip::between(width, &samples, &now));
                    let difference = Difference::between(&samples, &now);
                    seen.differences_to_64.push(difference);
                }
                before = now;
            }
        },
    );
}

fn sampled(renderer: &mut ThreadedRenderer, level: Level, size: Size, scene: &Scene) -> Vec<u32> {
    let (mut mean, mut pixels) = (Mean::default(), vec![0; size.area()]);
    for i in 0..GRID * GRID {
        let place = |i: usize| (i as f32 + 0.5) / GRID as f32 - 0.5;
        renderer.set_offset(place(i % GRID), place(i / GRID));
        renderer.draw(level, scene, &Quality::EXHAUSTIVE, size.width, &mut pixels);
        mean.add(&pixels);
    }
    renderer.set_offset(0.0, 0.0);
    mean.write(&mut pixels);
    pixels
}
