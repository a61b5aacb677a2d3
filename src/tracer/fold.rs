//! Kaleidoscopes, see `Presentation::sectors`: one part of the picture is drawn, and copied to the
//! rest.

use crate::maths::to_f32;
use crate::picture::{Band, CELL};
use crate::scene::Camera;
use glam::{Vec2, vec2};

#[derive(Clone, Copy)]
pub(crate) struct Fold {
    /// The upper left corner of the part that is drawn, in cells.
    centre: [usize; 2],
    has_diagonal: bool,
    /// Whether the wedge of eight sectors is to the right of its diagonal. If it is to the left,
    /// cells on both sides of the diagonal are drawn.
    is_wide: bool,
    pub offset: Vec2,
}

/// More cells than a picture is wide.
const NONE: usize = 1 << 16;

impl Fold {
    pub fn new(sectors: f32, camera: &Camera, [width, height]: [usize; 2]) -> Self {
        let exact = |share: f32, is_folded: bool| if is_folded { share } else { 0.0 };
        let x = exact(0.5 * to_f32(width), sectors >= 2.0);
        // The same point of the picture plane at all aspects.
        let above = 0.04 / camera.widening(width, height);
        let y = exact((0.5 - above) * to_f32(height), sectors >= 4.0);
        let centre = [x, y].map(|at| at as usize / CELL);
        let [left, top] = centre.map(|cells| cells * CELL);
        Self {
            centre,
            has_diagonal: sectors >= 8.0,
            is_wide: width - left >= height - top,
            offset: vec2(x - to_f32(left), y - to_f32(top)),
        }
    }

    /// Returns the first cell of a row within `margin` cells of the drawn part.
    #[inline(never)]
    pub fn start(&self, row: usize, margin: usize) -> usize {
        let [left, top] = self.centre;
        let Some(down) = (row + margin).checked_sub(top) else {
            return NONE;
        };
        let is_cut = self.has_diagonal && self.is_wide;
        let cut = if is_cut { down.saturating_sub(2 * margin) } else { 0 };
        (left + cut).saturating_sub(margin)
    }

    /// Copies the drawn part to the rest, from the last row backwards: each half mirrors a finished
    /// one. Only the diagonal reads along columns.
    pub fn copy(&self, picture: &mut Band<'_>) {
        let [left, top] = self.centre.map(|cells| cells * CELL);
        if left == 0 && !self.has_diagonal {
            return;
        }
        let (width, stride) = (picture.width, picture.stride);
        for y in (0..picture.height()).rev() {
            let row = y * stride;
            if y < top {
                let from = (2 * top - 1 - y) * stride;
                picture.pixels.copy_within(from..from + width, row);
                continue;
            }
            if self.has_diagonal {
                let column = left + y - top;
                for x in if self.is_wide { left..column } else { column..width } {
                    let from = (top + x - left) * stride + column;
                    picture.pixels[row + x] = picture.pixels[from];
                }
            }
            for x in 0..left {
                picture.pixels[row + x] = picture.pixels[row + 2 * left - 1 - x];
            }
        }
    }
}
