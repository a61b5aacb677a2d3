//! Captions over a finished picture. A pixel's coverage depends on its distance to the nearest
//! stroke: edges are antialiased at any size.

use crate::font::strokes;
use crate::maths::{round, sqrt, to_f32};
use crate::picture::{Band, Frame};
use crate::presentation::Caption;
use glam::{Vec2, vec2};

/// In grid units: the letters' shadows just touch.
const ADVANCE: f32 = 2.0 + 2.0 * (HALF_WIDTH + SHADOW);

const HALF_WIDTH: f32 = 0.3;

/// In grid units: makes text readable on white.
const SHADOW: f32 = 0.35;

const DARKNESS: f32 = 0.7;

pub(crate) struct Overlay<'a> {
    pub captions: &'a [Caption],
    /// See [`Caption::letters`].
    pub numbers: &'a [usize],
    pub middle: f32,
    pub height: usize,
}

impl Overlay<'_> {
    pub fn is_empty(&self) -> bool {
        self.captions.is_empty()
    }

    pub fn draw(&self, band: &mut Band<'_>) {
        for caption in self.captions {
            if caption.brightness != 0.0 {
                self.draw_caption(caption, band);
            }
        }
    }

    fn draw_caption(&self, caption: &Caption, band: &mut Band<'_>) {
        let (w, h) = (to_f32(band.width), to_f32(self.height));
        let unit = 0.25 * caption.size * h.min(w * (9.0 / 16.0));
        let line = caption.middle * h - to_f32(band.top);
        for (y, row) in band.rows() {
            let y = (to_f32(y) + 0.5 - line) / unit;
            if y.abs() > 2.0 + HALF_WIDTH + SHADOW {
                continue;
            }
            for (x, pixel) in row.iter_mut().enumerate() {
                // In grid units from the middle of the first letter.
                let letters = to_f32(caption.letters.len()) - 1.0;
                let x =
                    (to_f32(x) + 0.5 - self.middle * w) / unit + self.middle * ADVANCE * letters;
                let index = round(x / ADVANCE);
                if index < 0.0 {
                    continue;
                }
                let Some(letter) = letter(&caption.letters, index as usize, self.numbers) else {
                    break;
                };
                let at = vec2(x - index * ADVANCE + 1.0, y + 2.0);
                let inside = HALF_WIDTH - distance(at, letter);
                let share = |share: f32| share.clamp(0.0, 1.0) * caption.brightness;
                let white = share(inside * unit + 0.5);
                let shadow = share(1.0 + inside * (1.0 / SHADOW)) * DARKNESS;
                *pixel = blend(*pixel, shadow.max(white), [white; 3]);
            }
        }
    }
}

impl Frame<'_> {
    /// Draws captions over a finished picture, aligned to its left side, with the digits of four
    /// numbers, see [`Caption::letters`].
    ///
    /// # Panics
    /// If the frame has too few pixels.
    pub fn write(&mut self, captions: &[Caption], numbers: [usize; 4]) {
        let overlay = Overlay { captions, numbers: &numbers, middle: 0.0, height: self.height };
        overlay.draw(&mut self.band(&mut []));
    }
}

fn letter(letters: &[u8], index: usize, numbers: &[usize]) -> Option<u8> {
    let (&letter, after) = letters.get(index..)?.split_first()?;
    let Some(number) = numbers.get(usize::from(letter.wrapping_sub(b'#'))) else {
        return Some(letter);
    };
    let places = after.iter().filter(|&&next| next == letter);
    let number = places.fold(*number, |number, _| number / 10);
    // No leading zeros.
    Some(if number > 0 { b'0' + (number % 10) as u8 } else { b' ' })
}

/// Returns the distance from a point to the letter's nearest stroke, in grid units, at most 1.
fn distance(at: Vec2, letter: u8) -> f32 {
    let mut distance2 = 1.0_f32;
    for (from, to) in strokes(letter) {
        let (at, stroke) = (at - from, to - from);
        let along = (at.dot(stroke) / stroke.length_squared()).clamp(0.0, 1.0);
        distance2 = distance2.min((at - stroke * along).length_squared());
    }
    sqrt(distance2)
}

/// Darkens a pixel by the share `covered`, 0 to 1, and adds blue, green and red shares, at most
/// `covered`. Not inlined: 240 packed bytes less.
#[inline(never)]
fn blend(pixel: u32, covered: f32, added: [f32; 3]) -> u32 {
    // In 256ths; invalid scenes exceed the limits.
    let rounded = |share: f32| (256.0 * share + 0.5) as u32;
    let covered = rounded(covered).min(256);
    let channel = |number: usize| {
        let picture = (pixel >> (8 * number)) & 0xff;
        let added = rounded(added[number]).min(covered);
        (picture * (256 - covered) + 255 * added) >> 8 << (8 * number)
    };
    channel(0) | channel(1) | channel(2)
}
