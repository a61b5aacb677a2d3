//! Tests for shadows and images on planes between the corners of a square.

use super::search::{ALL, Covered, SQUARE_ROWS, Search};
use crate::coverage::{Rect, Region, Sides};
use glam::{Vec4, Vec4Swizzles};

impl Search<'_> {
    /// Tests one square against an image or a shadow on a plane that some of its corners show.
    ///
    /// An image opens the square unless one corner, or all four if the image is thin, shows the
    /// plane inside the region. If only one straight side of the region cuts a square whose corners
    /// all show the plane, a corner is inside, since a half-plane that meets a square contains a
    /// corner. The square is also opened if some corners are outside the region and none of these
    /// shows the plane: between them and the region, the plane may be visible.
    ///
    /// A shadow follows the same rules, but opens the square only in [`Search::settle`]: another
    /// shadow may cover the square.
    pub(super) fn look_on_plane(&mut self, shown: u64, region: &Region, x: usize, y: usize) {
        let rect = self.squares.coverage.axes.rect(self.squares.pixels(x, y));
        let cuts = cuts(region, rect);
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

    /// Opens the squares that may miss a shadow from the current light, or a slit between two
    /// shadows or images.
    #[inline(never)]
    pub(super) fn settle(&mut self) {
        let rows = self.squares.rows;
        for (covered, open) in self.covered[..rows].iter_mut().zip(&mut self.open) {
            *open = *open | covered.missed.without(covered.wholly);
            *covered = Covered::NONE;
        }
    }
}

/// Returns the number of inner sides that the rectangle is not wholly inside. A cone counts as two
/// sides, since the rule for one straight side (`Search::look_on_plane`) does not hold for it.
#[inline(always)]
fn cuts(region: &Region, rect: Rect) -> u32 {
    let Sides::Flat { inner, .. } = &region.sides else {
        return 2;
    };
    let middle = (rect.xy() + rect.zw()) * 0.5;
    let half = rect.zw() - middle;
    let cuts = inner.map(|[right, down, origin]| {
        let min = right * middle.x - right.abs() * half.x
            + (down * middle.y - down.abs() * half.y)
            + origin;
        // NaN counts as a cut.
        (!min.cmpge(Vec4::splat(region.margin))).bitmask().count_ones()
    });
    cuts[0] + cuts[1]
}
