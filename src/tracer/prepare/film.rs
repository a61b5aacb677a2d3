//! How light becomes the picture's colours, see [`crate::scene::Film`].

use crate::lanes::*;
use crate::scene;
use crate::scene::camera::pixels;
use fearless_simd::{f32x4, u16x8, u64x2};
use glam::{Vec2, vec2};

/// The film of a frame. Colours are in output steps, 255 the brightest; positions in pixels of the picture.
pub(crate) struct Film {
    /// Whether colours stay as they are.
    pub is_plain: bool,
    shoulder: f32,
    /// From the shoulder to full brightness.
    room: f32,
    vignette: f32,
    middle: Vec2,
    /// 1 / half the picture's height.
    unit: f32,
    /// See [`Dither`].
    pub dither: Dither,
}

/// The light or the colours of four points: blue, green, red, and one number of no meaning.
pub(crate) type Four = [f32x4<Baseline>; 4];

/// Thresholds that are added to a pixel's colour before the fraction of an output step is cut off, in 256ths of a step: a word for each
/// channel of the pixel (x, y), all alike, at `[y % 4][x % 4]`, and again four further on.
pub(crate) type Dither = [[u64; 8]; 4];

/// Half an output step everywhere.
#[cfg(test)]
pub(crate) const ROUND: Dither = [[128 * WORDS; 8]; 4];

/// A one in each word of a [`Dither`].
const WORDS: u64 = 0x0001_0001_0001_0001;

/// The least room above a shoulder, so that it can be divided by: it makes no difference to any output step.
const LEAST_ROOM: f32 = 1e-3;

impl Film {
    /// All zeros: memory before a frame is prepared.
    pub const ZERO: Self = Self {
        is_plain: false,
        shoulder: 0.0,
        room: 0.0,
        vignette: 0.0,
        middle: Vec2::ZERO,
        unit: 0.0,
        dither: [[0; 8]; 4],
    };

    /// Prepares the film for a picture of `width` by `height` pixels.
    pub fn of(film: &scene::Film, width: usize, height: usize) -> Self {
        let (width, height) = (pixels(width), pixels(height));
        Self {
            is_plain: *film == scene::Film::PLAIN,
            shoulder: 255.0 * film.shoulder,
            room: (255.0 * (1.0 - film.shoulder)).max(LEAST_ROOM),
            vignette: film.vignette,
            middle: 0.5 * vec2(width - 1.0, height - 1.0),
            unit: 2.0 / height,
            dither: dither(film.dither),
        }
    }

    /// The threshold that is added to the pixel (x, y), see [`Dither`], but in 128ths of a step.
    pub fn threshold(&self, x: usize, y: usize) -> u64 {
        // The words are even.
        self.dither[y % 4][x % 4] >> 1
    }

    /// The same for four pixels from (x, y) to the right, two at a time.
    #[inline(always)]
    pub fn thresholds(&self, simd: Baseline, x: usize, y: usize) -> [u16x8<Baseline>; 2] {
        [0, 2].map(|i| {
            let two = &self.dither[y % 4][x % 4 + i..][..2];
            u64x2::from_slice(simd, two).bitcast::<u16x8<Baseline>>() >> 1
        })
    }

    /// The number by which light is divided at four points, of which x and y are given.
    #[inline(always)]
    fn dimming(&self, [x, y]: [f32x4<Baseline>; 2]) -> f32x4<Baseline> {
        let x = (x - self.middle.x) * self.unit;
        let y = (y - self.middle.y) * self.unit;
        (x * x + y * y) * self.vignette + 1.0
    }

    /// Turns the light at four points, of which x and y are given, into colours, channel by channel.
    #[inline(never)]
    pub fn expose(&self, simd: Baseline, light: &mut Four, at: [f32x4<Baseline>; 2]) {
        let dimming: [f32; 4] = self.dimming(at).into();
        for (light, dimming) in light.iter_mut().zip(dimming) {
            *light /= dimming;
        }
        let [a, b, c, d] = *light;
        let most = a.max(b).max(c.max(d));
        // Most is below the shoulder, and stays as it is.
        if most.simd_gt(self.shoulder).any_true() {
            for light in light {
                let over = (*light - self.shoulder).max(splat(simd, 0.0));
                *light = *light - over + over * self.room / (over + self.room);
            }
        }
    }
}

/// Thresholds over a share of a step, by Bayer's ordered dither: pixels that follow each other in the order are far apart.
fn dither(share: f32) -> Dither {
    let mut dither = [[0; 8]; 4];
    for rank in 0..16 {
        let y = rank >> 2 & 1 | rank << 1 & 2;
        let x = (rank >> 3 | rank & 2) ^ y;
        // In 128ths of a step, as samples have them, so that squares and points round alike.
        let from_half = share * (8.0 * rank as f32 - 60.0);
        // Whatever the share is, it fits, and the brightest colour with it in a byte.
        let threshold = 2 * u64::from((from_half + 64.5).min(127.0) as u8) * WORDS;
        dither[y][x] = threshold;
        dither[y][x + 4] = threshold;
    }
    dither
}
