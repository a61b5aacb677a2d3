//! Kaleidoscopes, see [`Scene::sectors`](crate::scene::Scene::sectors): a wedge of the picture is drawn, and the rest copies it.

use crate::picture::{Band, CELL};
use core::ops::Range;

pub(crate) struct Fold {
    /// The corner of the wedge, in cells.
    centre: [usize; 2],
    has_diagonal: bool,
    /// Whether the wedge with a diagonal is to the right of the centre. Otherwise it is below.
    is_wide: bool,
}

impl Fold {
    pub fn new(sectors: f32, [width, height]: [usize; 2]) -> Self {
        let cells = |at: usize, is_folded: bool| at / CELL * usize::from(is_folded);
        let centre = [cells(width / 2, sectors >= 2.0), cells(height * 23 / 50, sectors >= 4.0)];
        let [right, below] = [width - CELL * centre[0], height - CELL * centre[1]];
        Self { centre, has_diagonal: sectors >= 8.0, is_wide: right >= below }
    }

    /// Returns the columns of the wedge's cells in a row of cells, with `margin` cells around it, 0 or 1.
    pub fn cells(&self, row: usize, margin: usize) -> Range<usize> {
        let [left, top] = self.centre;
        let Some(down) = (row + margin).checked_sub(top) else {
            return 0..0;
        };
        let edge = left.saturating_sub(margin);
        match (self.has_diagonal, self.is_wide) {
            (false, _) => edge..usize::MAX,
            (true, true) => edge.max((left + down).saturating_sub(3 * margin))..usize::MAX,
            (true, false) => edge..left + down + 1 + margin,
        }
    }

    /// Returns the pixel that the pixel (x, y) copies.
    #[inline(always)]
    pub fn source(&self, [x, y]: [usize; 2]) -> [usize; 2] {
        let [left, top] = self.centre.map(|cells| CELL * cells);
        let off =
            |at: usize, middle: usize| if at < middle { middle - 1 - at } else { at - middle };
        let mut off = [off(x, left), off(y, top)];
        if self.has_diagonal && (off[0] < off[1]) == self.is_wide {
            off.reverse();
        }
        [left + off[0], top + off[1]]
    }

    /// Copies the wedge to the rest of a picture.
    pub fn copy(&self, picture: &mut Band<'_>) {
        let [left, top] = self.centre.map(|cells| CELL * cells);
        if left + top == 0 && !self.has_diagonal {
            return;
        }
        let (width, height, stride) = (picture.width, picture.height(), picture.stride);
        for y in top..height {
            // The other columns are in the wedge.
            let end = if !self.has_diagonal {
                left
            } else if self.is_wide {
                width.min(left + y - top)
            } else {
                width
            };
            for x in 0..end {
                let [from, row] = self.source([x, y]);
                picture.pixels[y * stride + x] = picture.pixels[row * stride + from];
            }
        }
        for y in 0..top {
            let row = (2 * top - 1 - y) * stride;
            picture.pixels.copy_within(row..row + width, y * stride);
        }
    }
}
