use crate::arguments::processors;
use crate::interrupt;
use crate::technique::Technique;
use eightfold_harness::Size;
use eightfold_harness::error::{Difference, pops};
use eightfold_harness::picture::{Mean, rgb};
use eightfold_harness::threaded_renderer::ThreadedRenderer;
use eightfold_tracer::{Level, Quality, presentation::Moment};
use nv_flip::FlipImageRgb8;
use rayon::prelude::*;

const SAMPLES_PER_SIDE: usize = 8;

#[derive(Clone, Default)]
pub struct ViewErrors {
    /// Mean FLIP to the reference, per view.
    pub flips: Vec<f64>,
    /// Per pair of frames.
    pub pops: Vec<f64>,
    pub differences_to_64: Vec<Difference>,
    pub flips_to_64: Vec<f64>,
}

/// Adds the errors of a view with consecutive frames of `scenes`, relative to the first technique.
pub fn add_errors(
    techniques: &[Technique],
    level: Level,
    size: Size,
    scenes: &[Moment],
    errors: &mut [ViewErrors],
) {
    let width = size.width;
    let draw = |technique: &Technique, scene: &Moment, renderer: &mut ThreadedRenderer| {
        let mut pixels = vec![0; size.area()];
        technique.draw(renderer, level, scene, width, &mut pixels);
        pixels
    };
    let mut renderer = ThreadedRenderer::new(processors());
    let references = scenes.iter();
    let references = references.map(|scene| draw(&techniques[0], scene, &mut renderer));
    let references: Vec<Vec<u32>> = references.collect();
    let samples = sampled(&mut renderer, level, size, &scenes[0]);
    let each = techniques.par_iter().zip(errors);
    each.for_each_init(
        || ThreadedRenderer::new(1),
        |renderer, (technique, errors)| {
            let own: Vec<Vec<u32>>;
            let references = if technique.quality.edge == techniques[0].quality.edge {
                &references
            } else {
                let reference = technique.reference();
                let frames = scenes.iter();
                own = frames.map(|scene| draw(&reference, scene, renderer)).collect();
                &own
            };
            let mut before: Vec<u32> = Vec::new();
            for (i, scene) in scenes.iter().enumerate() {
                if interrupt::is_stopped() {
                    return;
                }
                let now = draw(technique, scene, renderer);
                if i > 0 {
                    let references = [&references[i - 1][..], &references[i]];
                    let pops = pops(references, [&before, &now]);
                    errors.pops.push(pops as f64);
                } else {
                    let flip = |picture: &[u32]| mean(&flip(width, picture, &now));
                    errors.flips.push(flip(&references[0]));
                    errors.flips_to_64.push(flip(&samples));
                    let difference = Difference::between(&samples, &now);
                    errors.differences_to_64.push(difference);
                }
                before = now;
            }
        },
    );
}

fn sampled(renderer: &mut ThreadedRenderer, level: Level, size: Size, scene: &Moment) -> Vec<u32> {
    let (mut mean, mut pixels) = (Mean::default(), vec![0; size.area()]);
    for i in 0..SAMPLES_PER_SIDE * SAMPLES_PER_SIDE {
        let place = |i: usize| (i as f32 + 0.5) / SAMPLES_PER_SIDE as f32 - 0.5;
        renderer.set_offset(place(i % SAMPLES_PER_SIDE), place(i / SAMPLES_PER_SIDE));
        renderer.draw(level, scene, &Quality::EXHAUSTIVE, size.width, &mut pixels);
        mean.add(&pixels);
    }
    renderer.set_offset(0.0, 0.0);
    mean.write(&mut pixels);
    pixels
}

/// FLIP's default: 3840 pixels on 0.7 m at a distance of 0.7 m.
pub const PIXELS_PER_DEGREE: f32 = 67.0;

/// Returns the visible difference of `0x00RRGGBB` pixels that alternate, from 0 to 1 (Andersson et
/// al., "FLIP: A Difference Evaluator for Alternating Images", 2020).
pub fn flip(width: usize, reference: &[u32], test: &[u32]) -> Vec<f32> {
    if reference == test {
        return vec![0.0; test.len()];
    }
    let [reference, test] = [reference, test].map(|pixels| {
        let height = pixels.len() / width;
        FlipImageRgb8::with_data(width as u32, height as u32, &rgb(pixels))
    });
    nv_flip::flip(reference, test, PIXELS_PER_DEGREE).to_vec()
}

pub fn mean(errors: &[f32]) -> f64 {
    let sum: f64 = errors.iter().map(|&error| f64::from(error)).sum();
    sum / errors.len() as f64
}
