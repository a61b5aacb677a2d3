//! How far apart a viewer sees two pictures: FLIP, the difference evaluator of rendering research.
//!
//! Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström and Fairchild, "FLIP: A Difference Evaluator for Alternating
//! Images", 2020. It models a viewer who switches between the two pictures: colours are filtered by what the eye resolves
//! at a distance, and edges and points that differ weigh more.

use nv_flip::{FlipImageRgb8, flip};

/// Pixels in a degree of the viewer's field: FLIP's own default, a screen of 3840 pixels on 0.7 m seen from 0.7 m.
pub const PIXELS_PER_DEGREE: f32 = 67.0;

/// What FLIP says of two pictures: 0 where no difference is seen, up to 1.
pub struct Flip {
    /// Of each pixel.
    pub errors: Vec<f32>,
}

impl Flip {
    /// Between two pictures in `0x00RRGGBB` of the same size.
    pub fn between(width: usize, reference: &[u32], test: &[u32]) -> Self {
        let map = flip(
            image(width, reference),
            image(width, test),
            PIXELS_PER_DEGREE,
        );
        Self {
            errors: map.to_vec(),
        }
    }

    /// The mean of all pixels.
    pub fn mean(&self) -> f64 {
        let sum: f64 = self.errors.iter().map(|&error| f64::from(error)).sum();
        sum / self.errors.len() as f64
    }

    /// The least error that 99 of 100 pixels do not exceed.
    pub fn p99(&self) -> f64 {
        let mut errors = self.errors.clone();
        let rank = (errors.len() * 99).div_ceil(100) - 1;
        let (_, error, _) = errors.select_nth_unstable_by(rank, f32::total_cmp);
        f64::from(*error)
    }
}

fn image(width: usize, pixels: &[u32]) -> FlipImageRgb8 {
    let bytes: Vec<u8> = pixels
        .iter()
        .flat_map(|pixel| pixel.to_be_bytes().into_iter().skip(1))
        .collect();
    FlipImageRgb8::with_data(width as u32, (pixels.len() / width) as u32, &bytes)
}
