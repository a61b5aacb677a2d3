//! FLIP: the visible difference between alternating pictures (Andersson et al., "FLIP: A Difference Evaluator for Alternating
//! Images", 2020).

use eightfold_harness::picture::rgb;
use nv_flip::FlipImageRgb8;

/// FLIP's default: 3840 pixels on 0.7 m at a distance of 0.7 m.
pub const PIXELS_PER_DEGREE: f32 = 67.0;

/// Compares `0x00RRGGBB` pixels. Returns the error per pixel, from 0, invisible, to 1.
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
