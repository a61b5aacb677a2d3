//! Tests for highlights between the corners of a square.

use super::{ALL, Search};
use crate::coverage::Highlight;
use crate::grid::{Bits, each};
use crate::maths::to_f32;
use crate::picture::TILE_HEIGHT;

impl Search<'_> {
    /// Opens squares in which a highlight may be visibly brighter than at the corners that show the object.
    pub(super) fn look_for_highlight(&mut self, highlight: &Highlight, all: &[Bits; TILE_HEIGHT]) {
        let squares = self.squares;
        let side = squares.side();
        let (is_even, reach) = (highlight.is_even(side), highlight.reach(side));
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
                    if !is_known && highlight.is_missed(squares.pixels(x, y), shown) {
                        self.open[y].set(x);
                    }
                });
            });
        }
    }
}
