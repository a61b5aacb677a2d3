//! FLIP: a measure of the difference that a viewer perceives between two pictures.
//!
//! Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström and Fairchild, "FLIP: A Difference Evaluator for Alternating
//! Images", 2020. It models a viewer who alternates between the pictures: colours are filtered by what the eye can resolve
//! at a given distance, and differences in edges and points weigh more.

use crate::picture::rgb;
use nv_flip::{FlipImageRgb8, flip};

/// Pixels per degree of the visual field: FLIP's default, for a screen of 3840 pixels on 0.7 m at a distance of 0.7 m.
pub const PIXELS_PER_DEGREE: f32 = 67.0;

/// The FLIP error of a picture, from 0, no visible difference, to 1.
pub struct Flip {
    /// The error of each pixel, row by row.
    pub errors: Vec<f32>,
}

impl Flip {
    /// Compares two pictures of `0x00RRGGBB` pixels and the same size.
    pub fn between(width: usize, reference: &[u32], test: &[u32]) -> Self {
        if reference == test {
            let errors = vec![0.0; test.len()];
            return Self { errors };
        }
        let map = flip(
            image(width, reference),
            image(width, test),
            PIXELS_PER_DEGREE,
        );
        Self {
            errors: map.to_vec(),
        }
    }

    /// The mean over all pixels.
    pub fn mean(&self) -> f64 {
        let sum: f64 = self.errors.iter().map(|&error| f64::from(error)).sum();
        sum / self.errors.len() as f64
    }
}

/// The FLIP errors of the pixels of some pictures together.
#[derive(Clone, Default)]
pub struct Flips {
    sum: f64,
    pixels: usize,
}

impl Flips {
    /// Adds the pixels of another picture.
    pub fn add(&mut self, flip: &Flip) {
        self.sum += flip.mean() * flip.errors.len() as f64;
        self.pixels += flip.errors.len();
    }

    /// The mean over all pixels; `None` without any pictures.
    pub fn mean(&self) -> Option<f64> {
        (self.pixels > 0).then(|| self.sum / self.pixels as f64)
    }
}

fn image(width: usize, pixels: &[u32]) -> FlipImageRgb8 {
    let height = pixels.len() / width;
    FlipImageRgb8::with_data(width as u32, height as u32, &rgb(pixels))
}
