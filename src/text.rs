//! Captions: strokes drawn over the rows of a finished band.
//!
//! A pixel's share of a stroke is taken from its centre's distance to it, so edges are smooth at any size. Each row is drawn
//! by whoever drew its band: the bits are the same for any number of threads.

use crate::font::{ADVANCE, strokes};
use crate::maths::{round, sqrt};
use crate::refine::Band;
use crate::scene::Caption;
use crate::scene::camera::pixels;
use glam::{Vec2, vec2};

/// Half the width of a stroke, in grid units.
const HALF: f32 = 0.22;

/// How far the dark edge about a stroke reaches, in grid units: it is read on white, and ends where the next letter begins.
const EDGE: f32 = 0.28;

/// Draws captions over a band of a picture of some height.
pub(crate) fn draw(captions: &[Caption], height: usize, band: &mut Band<'_>) {
    let (w, h) = (pixels(band.width), pixels(height));
    for caption in captions {
        if caption.brightness == 0.0 {
            continue;
        }
        // Pixels of a unit of the letters' grid; a letter is four high and two wide.
        let unit = 0.25 * caption.size * h.min(w * (9.0 / 16.0));
        let middle = caption.middle * h - pixels(band.top);
        for (y, row) in band.pixels.chunks_exact_mut(band.width.max(1)).enumerate() {
            let y = (pixels(y) + 0.5 - middle) / unit;
            // A letter, and room for the strokes' width.
            if y.abs() > 2.5 {
                continue;
            }
            for (x, pixel) in row.iter_mut().enumerate() {
                // From the middle of the first letter.
                let letters = pixels(caption.letters.len()) - 1.0;
                let x = (pixels(x) + 0.5 - 0.5 * w) / unit + 0.5 * ADVANCE * letters;
                let number = round(x / ADVANCE);
                if number < 0.0 {
                    continue;
                }
                let Some(&letter) = caption.letters.get(number as usize) else {
                    break;
                };
                let at = vec2(x - number * ADVANCE + 1.0, y + 2.0);
                let inside = (HALF - distance(at, letter)) * unit + 0.5;
                let share = |inside: f32| inside.clamp(0.0, 1.0) * caption.brightness;
                *pixel = write(*pixel, share(inside + EDGE * unit), share(inside));
            }
        }
    }
}

/// From a point to the nearest of a letter's strokes, in grid units, or 1 if it is farther away.
fn distance(at: Vec2, letter: u8) -> f32 {
    let mut distance2 = 1.0_f32;
    for (from, to) in strokes(letter) {
        let (at, way) = (at - from, to - from);
        let along = (at.dot(way) / way.length_squared()).clamp(0.0, 1.0);
        distance2 = distance2.min((at - way * along).length_squared());
    }
    sqrt(distance2)
}

/// A pixel with a share of it covered, and a share of it, no larger, white.
fn write(pixel: u32, covered: f32, white: f32) -> u32 {
    // In 256ths, to the nearest. (A brightness that a scene may not have, above 1, is as much as 1.)
    let [covered, white] = [covered, white].map(|share| ((256.0 * share + 0.5) as u32).min(256));
    let channel = |shift: u32| {
        let picture = (pixel >> shift) & 0xff;
        (picture * (256 - covered) + 255 * white) >> 8 << shift
    };
    channel(16) | channel(8) | channel(0)
}
