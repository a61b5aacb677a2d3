//! FLIP: the visible difference between alternating pictures (Andersson et al., "FLIP: A Difference Evaluator for Alternating
//! Images", 2020).

use eightfold_harness::picture::rgb;
use nv_flip::{FlipImageRgb8, flip};

/// FLIP's default: 3840 pixels on 0.7 m at a distance of 0.7 m.
pub const PIXELS_PER_DEGREE: f32 = 67.0;

/// The error per pixel, from 0, invisible, to 1.
pub struct Flip {
    pub errors: Vec<f32>,
}

impl Flip {
    /// Compares `0x00RRGGBB` pixels.
    pub fn between(width: usize, reference: &[u32], test: &[u32]) -> Self {
        if reference == test {
            let errors = vec![0.0; test.len()];
            return Self { errors };
        }
        let [reference, test] = [reference, test].map(|pixels| image(width, pixels));
        let errors = flip(reference, test, PIXELS_PER_DEGREE).to_vec();
        Self { errors }
    }

    pub fn mean(&self) -> f64 {
        let sum: f64 = self.errors.iter().map(|&error| f64::from(error)).sum();
        sum / self.errors.len() as f64
    }
}

fn image(width: usize, pixels: &[u32]) -> FlipImageRgb8 {
    let height = pixels.len() / width;
    FlipImageRgb8::with_data(width as u32, height as u32, &rgb(pixels))
}
