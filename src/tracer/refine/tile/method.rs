//! The method's overlay: traced points and filled squares, drawn over the picture.
//!
//! Points on a band's first row are marked only if this band traced them.

use super::state::Tile;
use crate::observe::Observer;
use crate::picture::TILE_WIDTH;

/// A pixel on the upper or left side of a filled square; its other sides belong to neighbours.
const SIDE_MARK: u8 = 1;
const POINT_MARK: u8 = 2;

/// The width of the front in pixels.
const FRONT: usize = 3;

impl<O: Observer> Tile<'_, '_, O> {
    pub(super) fn show_method(&mut self) {
        let plan = self.context.plan;
        let start = plan.finished.max(self.area.left);
        if start >= self.area.right {
            return;
        }
        let method = &plan.method;
        let both = method.squares.max(method.points);
        let blends = [0.0, method.squares, method.points, both].map(|mark| {
            let white = rounded(mark, 255);
            // The picture's weight in 256ths. The sum never exceeds full brightness.
            let left = rounded((1.0 - mark) * method.picture, 256);
            (left.min(256 - white), white)
        });
        for y in 0..self.area.rows(0) {
            let marks = self.marks(y);
            let row = y * self.band.stride;
            let row = &mut self.band.pixels[row + start..row + self.area.right];
            for (pixel, &mark) in row.iter_mut().zip(&marks[start - self.area.left..]) {
                let (left, white) = blends[mark as usize];
                // Most pixels of a coarse picture stay.
                if left < 256 {
                    let red_blue = (((*pixel & 0xff_00_ff) * left) >> 8) & 0xff_00_ff;
                    let green = (((*pixel & 0xff_00) * left) >> 8) & 0xff_00;
                    *pixel = red_blue + green + white * 0x01_01_01;
                }
            }
            // The front is in this tile.
            if start > self.area.left {
                let line = row.iter_mut().take(FRONT);
                line.for_each(|pixel| *pixel = 0xff_ff_ff);
            }
        }
    }

    fn marks(&self, y: usize) -> [u8; TILE_WIDTH] {
        let mut row = [0; TILE_WIDTH];
        for level in 0..=self.context.plan.quality.top_level() {
            let side = 1 << level;
            let is_upper = y.is_multiple_of(side);
            if level > 0 {
                self.worker.marks.filled[level][y / side].for_each(|x| {
                    let length = if is_upper { side } else { 1 };
                    let sides = row.iter_mut().skip(x * side).take(length);
                    sides.for_each(|mark| *mark |= SIDE_MARK);
                });
            }
            if is_upper {
                self.worker.marks.traced[level][y / side].for_each(|x| {
                    if let Some(mark) = row.get_mut(x * side) {
                        *mark |= POINT_MARK;
                    }
                });
            }
        }
        row
    }
}

/// Returns a share of `max`, 0 to `max`.
fn rounded(share: f32, max: u16) -> u32 {
    ((share * f32::from(max) + 0.5) as u32).min(u32::from(max))
}
