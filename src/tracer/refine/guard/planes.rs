//! Tests for shadows and images on planes between the corners of a square.

use super::{ALL, Search};
use crate::coverage::Region;
use crate::grid::Bits;
use crate::picture::TILE_HEIGHT;

pub(super) const SQUARE_ROWS: usize = TILE_HEIGHT / 2;

/// The squares of a row in three sets, by how many of their corners are covered: either by the shadows from one light, or by the images.
///
/// A convex outline around all corners covers the square. Two outlines that each cover some corners may leave a slit between them, so the
/// square is opened.
#[derive(Clone, Copy)]
pub(super) struct Covered {
    /// One outline covers all corners.
    wholly: Bits,
    /// One outline covers some corners that show the plane.
    partly: Bits,
    /// Too few corners show a shadow, or two outlines each cover some corners.
    missed: Bits,
}

impl Covered {
    pub const NONE: Self = Self { wholly: Bits::NONE, partly: Bits::NONE, missed: Bits::NONE };
}

impl Search<'_> {
    /// Tests one square against an image or a shadow on a plane that some of its corners show.
    ///
    /// An image opens the square unless a corner that shows the plane is inside the region; a thin image needs all four such corners. If
    /// only one straight side of the region cuts a square whose corners all show the plane, a corner is inside, since a half-plane that
    /// meets a square contains a corner. The square is also opened if some corners are outside the region and none of these shows the
    /// plane: between them and the region, the plane may be visible.
    ///
    /// A shadow follows the same rules, but opens the square only in [`Search::settle`]: another shadow may cover the square.
    pub(super) fn look_on_plane(&mut self, shown: u64, region: &Region, x: usize, y: usize) {
        let rect = self.squares.coverage.axes.rect(self.squares.pixels(x, y));
        let cuts = region.sides.cuts(rect, region.margin);
        let is_cut_once = cuts == 1 && shown == ALL;
        let inside = match cuts {
            0 => ALL,
            // A corner is inside; which one does not matter.
            _ if is_cut_once => 1,
            _ => region.corners(rect),
        };
        let covered = &mut self.covered[y % SQUARE_ROWS];
        let is_between = shown != ALL && shown & !inside == 0;
        let is_open = is_between || shown & inside < self.enough;
        if inside == ALL {
            covered.wholly.set(x);
        } else if is_open && self.light.is_none() {
            self.open[y].set(x);
        } else if is_open || shown & !inside != 0 && covered.partly.has(x) {
            covered.missed.set(x);
        } else if shown & !inside != 0 {
            covered.partly.set(x);
        }
    }

    /// Opens the squares that may miss a shadow from the current light, or a slit between two shadows or images.
    #[inline(never)]
    pub(super) fn settle(&mut self) {
        let rows = self.squares.rows;
        for (covered, open) in self.covered[..rows].iter_mut().zip(&mut self.open) {
            *open = *open | covered.missed.without(covered.wholly);
            *covered = Covered::NONE;
        }
    }
}
