//! Tests for highlights between the corners of a square.

use super::search::{ALL, Search};
use crate::coverage::{Highlight, VISIBLE};
use crate::grid::{Bits, each};
use crate::maths::{sqrt, to_f32};
use crate::picture::TILE_HEIGHT;
use core::array;
use glam::{Vec4, Vec4Swizzles};

/// The side of the presets' largest squares, in pixels.
const SQUARE: f32 = 8.0;

/// The share of [`VISIBLE`] that a square may miss. With it and `COUNTED_DECAY`, 0 of 5,115
/// highlights on spheres and planes are missed, without them 1. They cost the model scene 0.05 %
/// more rays.
const SPARE: f32 = 0.6;

impl Search<'_> {
    /// Opens squares in which a highlight may be visibly brighter than at the corners that show the
    /// object.
    pub(super) fn look_for_highlight(&mut self, highlight: &Highlight, all: &[Bits; TILE_HEIGHT]) {
        let squares = self.squares;
        let side = squares.side();
        let (is_even, reach) = (is_even(highlight, side), reach(highlight, side));
        for y in 0..squares.rows {
            let y = y % TILE_HEIGHT;
            let row = squares.pixels(0, y);
            if row.w < highlight.bounds.y || row.y > -highlight.bounds.w {
                continue;
            }
            let ends = highlight.columns(row.y, row.w, reach);
            let [first, last] = ends.map(|x| {
                let column = (x - to_f32(squares.area.left)) / to_f32(side);
                (column.max(0.0) as i32).min(squares.columns as i32 - 1)
            });
            Bits::masks(first, last, |i, mask| {
                each(all[y].0[i] & !self.open[y].0[i] & mask, |bit| {
                    let x = 64 * i + bit;
                    let shown = squares.shown(x, y, highlight.object);
                    let is_known = shown == 0 || shown == ALL && is_even;
                    if !is_known && is_missed(highlight, squares.pixels(x, y), shown) {
                        self.open[y].set(x);
                    }
                });
            });
        }
    }
}

/// Returns whether one corner is nearly as bright as the brightest point, in every square of `side`
/// pixels whose corners all show the object.
///
/// The nearest corner is at most half a side across and half a side down from the square's
/// brightest point. From that point to the corner, the decay u grows by no more than it does from
/// the highlight's centre to a point half a side across and half a side down.
fn is_even(highlight: &Highlight, side: usize) -> bool {
    let [a, b, c] = highlight.decay;
    let half = 0.5 * to_f32(side);
    highlight.strength * (a + 2.0 * b.abs() + c) * half * half <= threshold(highlight, to_f32(side))
}

/// Returns the allowed difference between a square and its corners. Like tolerances it grows as
/// squares get smaller, up to 0.3 of the highlight.
fn threshold(highlight: &Highlight, width: f32) -> f32 {
    SPARE * (VISIBLE * SQUARE / width).min(0.5 * highlight.strength)
}

/// Returns the decay beyond which [`is_missed`] is false for all squares of `side` pixels.
fn reach(highlight: &Highlight, side: usize) -> f32 {
    let peak = highlight.strength / threshold(highlight, to_f32(side));
    sqrt(2.0 * peak - 1.0) - 1.0
}

/// Returns whether a square, in pixels, may be visibly brighter than all corners whose bits are
/// set.
#[inline(never)]
fn is_missed(highlight: &Highlight, rect: Vec4, corners: u64) -> bool {
    let [a, b, c] = highlight.decay;
    let rect = rect - Vec4::from((highlight.middle, highlight.middle));
    let u = |x: Vec4, y: Vec4| a * x * x + y * (2.0 * b * x + c * y);
    let hidden = array::from_fn(|i| [f32::INFINITY, 0.0][(corners >> i & 1) as usize]);
    let corner = (u(rect.xzxz(), rect.yyww()) + Vec4::from_array(hidden)).min_element();
    // The brightest point is the highlight's centre, or on a side if the centre is outside.
    let mut min = 0.0;
    if rect.xy().max(-rect.zw()).max_element() > 0.0 {
        let sides = rect.xzyw();
        let along = (-b * sides / Vec4::new(c, c, a, a)).max(rect.yyxx()).min(rect.wwzz());
        let x = Vec4::from((sides.xy(), along.zw()));
        let y = Vec4::from((along.xy(), sides.zw()));
        min = u(x, y).min_element();
    }
    // e^-u is at most 1 / (1 + u + u^2 / 2), and e^-u - e^-v at most min(1, v - u) e^-u.
    let threshold = threshold(highlight, rect.z - rect.x);
    highlight.strength * (corner - min).min(1.0) > threshold * (1.0 + min + 0.5 * min * min)
}

/// Returns whether a square of 8 pixels may miss the highlight. From its middle to a corner, 4
/// pixels across and down, u grows to at most 64 times the larger of a and c.
pub(super) fn is_small(highlight: &Highlight, lights: usize) -> bool {
    let [a, _, c] = highlight.decay;
    highlight.strength * a.max(c) * SQUARE * SQUARE > VISIBLE / to_f32(lights)
}
