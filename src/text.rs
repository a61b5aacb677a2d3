//! Captions: strokes drawn over the rows of a finished band.
//!
//! A pixel's share of a stroke is taken from its centre's distance to it, so edges are smooth at any size. Each row is drawn
//! by whoever drew its band: the bits are the same for any number of threads.

use crate::refine::Band;
use crate::scene::Caption;
use crate::scene::camera::pixels;
use crate::show::letters::{ADVANCE, strokes};
use crate::trigonometry::root;
use glam::{Vec2, vec2};

/// Half the width of a stroke, in grid units: at 640x360 it is a pixel.
const HALF: f32 = 0.22;

/// How far the dark edge about a stroke reaches, in grid units: it is read on white, and ends where the next letter begins.
const EDGE: f32 = 0.28;

/// Draws captions over a band of a picture of some height.
#[inline(never)]
pub(crate) fn draw(captions: &[Caption], height: usize, band: &mut Band<'_>) {
    let (w, h) = (pixels(band.width), pixels(height));
    for caption in captions {
        if caption.brightness == 0.0 {
            continue;
        }
        // Pixels of a unit of the letters' grid; a letter is four high and two wide.
        let unit = 0.25 * caption.size * least(h, w * (9.0 / 16.0));
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
                let number = nearest(x / ADVANCE);
                if let Some(&letter) = caption.letters.get(number) {
                    let at = vec2(x - pixels(number) * ADVANCE + 1.0, y + 2.0);
                    let inside = (HALF - distance(at, letter)) * unit + 0.5;
                    let share = |inside: f32| {
                        let share = least(inside.max(0.0), 1.0) * caption.brightness;
                        nearest(256.0 * share) as u32
                    };
                    *pixel = write(*pixel, share(inside + EDGE * unit), share(inside));
                }
            }
        }
    }
}

/// From a point to the nearest of a letter's strokes, in grid units, or 1 if it is farther away.
#[inline(always)]
fn distance(at: Vec2, letter: u8) -> f32 {
    let mut square = 1.0;
    for (from, to) in strokes(letter) {
        let (at, way) = (at - from, to - from);
        let along = at.dot(way) / way.length_squared();
        let off = at - way * least(along.max(0.0), 1.0);
        square = least(off.length_squared(), square);
    }
    root(square)
}

/// The lesser of two numbers; `f32::min` takes care of those that are none.
#[inline(always)]
fn least(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// The whole number that is nearest, of one from 0 to 2^22; of one below something larger than any picture.
#[inline(always)]
pub(crate) fn nearest(x: f32) -> usize {
    const ROUND: f32 = 12_582_912.0;
    (x + ROUND).to_bits().wrapping_sub(ROUND.to_bits()) as usize
}

/// A pixel with some 256ths of it covered, and some of these, no more, with white.
#[inline(always)]
fn write(pixel: u32, covered: u32, white: u32) -> u32 {
    const EVERY_OTHER: u32 = 0x00ff_00ff;
    // Shares that make no sense overflow, and give some pixel.
    let mix = |channels: u32| {
        let picture = (channels & EVERY_OTHER).wrapping_mul(256_u32.wrapping_sub(covered));
        picture.wrapping_add(EVERY_OTHER.wrapping_mul(white)) >> 8 & EVERY_OTHER
    };
    mix(pixel) | mix(pixel >> 8) << 8 & 0x0000_ff00
}
