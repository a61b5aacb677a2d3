//! Draws captions over the rows of a band of a finished picture.
//!
//! The coverage of a pixel is computed from the distance of its centre to the nearest stroke, so edges are antialiased at any
//! size. Captions are placed in pixels of the picture, and drawn in rows of the band. Letters are measured in units of the font's
//! grid.

use crate::font::strokes;
use crate::maths::{round, sqrt};
use crate::picture::Band;
use crate::scene::Caption;
use crate::scene::camera::pixels;
use glam::{Vec2, vec2};

/// The distance between the left sides of neighbouring letters, in grid units: their shadows just touch.
const ADVANCE: f32 = 2.0 + 2.0 * (HALF_WIDTH + SHADOW);

/// Half the width of a stroke, in grid units.
const HALF_WIDTH: f32 = 0.3;

/// The width of the shadow around a stroke, in grid units: towards its rim it fades, and it makes text readable on white.
const SHADOW: f32 = 0.35;

/// The share of the picture that the shadow hides at most.
const DARKNESS: f32 = 0.7;

/// Draws captions over a band of a picture that is `height` pixels high. `numbers` are what [`Caption::letters`] may stand for. At
/// `middle` of the picture's width, 0 to 1, lies the same share of a line: 0.5 centres lines, and with 0 they begin at the left.
pub(crate) fn draw(
    captions: &[Caption],
    middle: f32,
    numbers: &[usize],
    height: usize,
    band: &mut Band<'_>,
) {
    let (w, h) = (pixels(band.width), pixels(height));
    for caption in captions {
        if caption.brightness == 0.0 {
            continue;
        }
        // The size of a grid unit in pixels. A letter is four units high and two wide.
        let unit = 0.25 * caption.size * h.min(w * (9.0 / 16.0));
        let line = caption.middle * h - pixels(band.top);
        for (y, row) in band.pixels.chunks_exact_mut(band.width.max(1)).enumerate() {
            let y = (pixels(y) + 0.5 - line) / unit;
            // Beyond half a letter and the shadow there is nothing to draw.
            if y.abs() > 2.0 + HALF_WIDTH + SHADOW {
                continue;
            }
            for (x, pixel) in row.iter_mut().enumerate() {
                // In grid units from the middle of the first letter.
                let letters = pixels(caption.letters.len()) - 1.0;
                let x = (pixels(x) + 0.5 - middle * w) / unit + middle * ADVANCE * letters;
                let index = round(x / ADVANCE);
                if index < 0.0 {
                    continue;
                }
                let Some(letter) = letter(&caption.letters, index as usize, numbers) else {
                    break;
                };
                let at = vec2(x - index * ADVANCE + 1.0, y + 2.0);
                let inside = HALF_WIDTH - distance(at, letter);
                let share = |share: f32| share.clamp(0.0, 1.0) * caption.brightness;
                let white = share(inside * unit + 0.5);
                let shadow = share(1.0 + inside * (1.0 / SHADOW)) * DARKNESS;
                *pixel = blend(*pixel, shadow.max(white), white);
            }
        }
    }
}

/// The letter of a caption at an index, a digit of a number where one stands for it; `None` beyond its end.
fn letter(letters: &[u8], index: usize, numbers: &[usize]) -> Option<u8> {
    let (&letter, after) = letters.get(index..)?.split_first()?;
    let Some(number) = numbers.get(usize::from(letter.wrapping_sub(b'#'))) else {
        return Some(letter);
    };
    let number = after.iter().fold(
        *number,
        |number, &next| {
            if next == letter { number / 10 } else { number }
        },
    );
    // No zeros lead a number.
    Some(if number > 0 {
        b'0' + (number % 10) as u8
    } else {
        b' '
    })
}

/// The distance from a point to the nearest of a letter's strokes, in grid units, at most 1.
fn distance(at: Vec2, letter: u8) -> f32 {
    let mut distance2 = 1.0_f32;
    for (from, to) in strokes(letter) {
        let (at, stroke) = (at - from, to - from);
        let along = (at.dot(stroke) / stroke.length_squared()).clamp(0.0, 1.0);
        distance2 = distance2.min((at - stroke * along).length_squared());
    }
    sqrt(distance2)
}

/// Blends a pixel to black by its share that is `covered`, and adds the share that is `white`, which is no larger.
fn blend(pixel: u32, covered: f32, white: f32) -> u32 {
    // Rounded to 256ths. A brightness above 1, which no valid scene has, counts as 1.
    let [covered, white] = [covered, white].map(|share| ((256.0 * share + 0.5) as u32).min(256));
    let channel = |shift: u32| {
        let picture = (pixel >> shift) & 0xff;
        (picture * (256 - covered) + 255 * white) >> 8 << shift
    };
    channel(16) | channel(8) | channel(0)
}
