use crate::lanes::*;
use crate::maths::to_f32;
use crate::scene;
use fearless_simd::{f32x4, u16x8, u64x2};
use glam::{Vec2, vec2};

/// Colours are in output steps of 1/255; positions in pixels.
pub(crate) struct Film {
    pub is_plain: bool,
    is_filmic: bool,
    /// The factor on light in fixed-point sums: filmic pictures sum four times the light, in steps
    /// four times larger.
    pub sum_unit: f32,
    vignette: f32,
    middle: Vec2,
    unit: f32,
    pub dither: Dither,
}

/// Four points' light or colours: blue, green, red, and an unused vector.
pub(crate) type Colours = [f32x4<Baseline>; 4];

/// Thresholds that are added to a pixel's colour before truncation, in 256ths of a step. The word
/// of the pixel (x, y), at `[y % 4][x % 4]` and again four further on, has one number for all
/// channels.
pub(crate) type Dither = [[u64; 8]; 4];

#[cfg(test)]
pub(crate) const ROUND: Dither = [[128 * ONES; 8]; 4];

/// 1 in each channel of a [`Dither`] word.
const ONES: u64 = 0x0001_0001_0001_0001;

impl Film {
    pub const ZERO: Self = Self {
        is_plain: false,
        is_filmic: false,
        sum_unit: 0.0,
        vignette: 0.0,
        middle: Vec2::ZERO,
        unit: 0.0,
        dither: [[0; 8]; 4],
    };

    pub fn of(film: &scene::Film, width: usize, height: usize) -> Self {
        let (width, height) = (to_f32(width), to_f32(height));
        Self {
            is_plain: *film == scene::Film::PLAIN,
            is_filmic: film.filmic,
            sum_unit: if film.filmic { 0.25 } else { 1.0 },
            vignette: film.vignette,
            middle: 0.5 * vec2(width - 1.0, height - 1.0),
            unit: 2.0 / height,
            dither: dither(film.dither),
        }
    }

    /// In 128ths of a step.
    pub fn threshold(&self, x: usize, y: usize) -> u64 {
        // The words are even.
        self.dither[y % 4][x % 4] >> 1
    }

    /// Returns the thresholds of four pixels from (x, y) to the right, in 128ths of a step.
    #[inline(always)]
    pub fn thresholds(&self, simd: Baseline, x: usize, y: usize) -> [u16x8<Baseline>; 2] {
        [0, 2].map(|i| {
            let two = &self.dither[y % 4][x % 4 + i..][..2];
            u64x2::from_slice(simd, two).bitcast::<u16x8<Baseline>>() >> 1
        })
    }

    #[inline(always)]
    fn dimming(&self, [x, y]: [f32x4<Baseline>; 2]) -> f32x4<Baseline> {
        let x = (x - self.middle.x) * self.unit;
        let y = (y - self.middle.y) * self.unit;
        (x * x + y * y) * self.vignette + 1.0
    }

    #[inline(never)]
    pub fn expose(&self, light: &mut Colours, at: [f32x4<Baseline>; 2]) {
        let dimming: [f32; 4] = self.dimming(at).into();
        for (light, dimming) in light.iter_mut().zip(dimming) {
            *light /= dimming;
        }
        if self.is_filmic {
            for light in light {
                *light = filmic(*light);
            }
        }
    }
}

#[inline(always)]
fn filmic(light: f32x4<Baseline>) -> f32x4<Baseline> {
    let c = light.max(splat(light.token(), 0.0)) * (1.0 / 255.0);
    let curve = c * (c * 2.51 + 0.03) / (c * (c * 2.43 + 0.59) + 0.14);
    curve.sqrt() * 255.0
}

/// Returns Bayer's ordered dither over a share of a step.
fn dither(share: f32) -> Dither {
    let mut dither = [[0; 8]; 4];
    for rank in 0..16 {
        let y = rank >> 2 & 1 | rank << 1 & 2;
        let x = (rank >> 3 | rank & 2) ^ y;
        // In 128ths of a step, as samples have them, so that squares and points round alike.
        let from_half = share * (8.0 * rank as f32 - 60.0);
        // For any share, the brightest colour plus its threshold fits in a byte.
        let threshold = 2 * u64::from((from_half + 64.5).min(127.0) as u8) * ONES;
        dither[y][x] = threshold;
        dither[y][x + 4] = threshold;
    }
    dither
}
