//! Finds the squares of a tile that may show a feature between their corners. `docs/guard.md` has
//! pictures of the rules.
//!
//! A tile meets few outlines. Tangents give the range of squares that an outline covers, for four
//! rows at once. A sample does not record shadows and images, so the guard tests the corner's
//! place: a corner that shows the plane and is inside an outline shows that shadow or image, or one
//! that covers it.
//!
//! A square is split, down to pixels, while it may show a feature that too few of its corners show.
//! One corner is enough if the feature's outline is wide. An outline thinner than one and a half
//! sides may pass between corners, so all four must show its feature.
//!
//! | kind | the square may be filled if |
//! | --- | --- |
//! | object | enough corners show it, or an occluder that all corners show hides it |
//! | image | no corner shows the plane, or enough that show it are inside the bound |
//! | shadow | the rule for images holds, or another shadow covers the square |
//! | highlight | no corner shows the object, or one that does is nearly as bright as any point |
//!
//! `planes` has two exceptions, `unguarded` the rule for light without a bound. `limits` lists
//! features that are missed.
//!
//! # Guarantees
//!
//! - Each visible object has at least one pixel: a square that meets its outline is filled only if
//!   a corner shows the object, or if an occluder hides the object in the whole square. An untraced
//!   pixel may get the mean colour of two traced points; it counts as showing the objects of both.
//! - A square that shows a plane and meets a sphere's shadow from a point light is filled only if a
//!   corner that shows the plane is inside that shadow, or all corners are inside another shadow
//!   from the same light. `rounding` derives the error margins. The shadow may still be lost if
//!   that corner would be as dark without the shadow.
//! - A frame shows every image of a sphere or a box in a flat first plane if the image has 2x2
//!   pixels or more and no other image covers a part of it.
//! - Thin bars, their shadows from a point light on a plane, and their images have holes of at most
//!   3 pixels (`tests/image/thin.rs`). A lower bound of an outline's width decides whether it is
//!   thin: the object's least extent, seen at its farthest distance.

mod highlights;
mod objects;
mod planes;
mod search;
mod squares;
mod unguarded;

use crate::coverage::{Coverage, MAX_HIGHLIGHTS, MAX_OUTLINES, Outline, Rect, Region, rectangle};
use crate::grid::{Area, Bits, each};
use crate::picture::TILE_HEIGHT;
use crate::prepare::{ObjectId, World};
use crate::quality::Quality;
use highlights::is_small;
use search::{ALL, Covered, SQUARE_ROWS, Search};
pub(crate) use squares::Squares;

/// A tile's highlights, and the outlines to test at its next level.
pub(crate) struct Guard {
    outlines: [u16; MAX_OUTLINES],
    count: usize,
    highlights: [u64; MAX_HIGHLIGHTS.div_ceil(64)],
}

zero! { Guard { outlines, count, highlights } }

impl Guard {
    pub fn begin(&mut self, world: World<'_>, coverage: &Coverage, area: &Area, rect: Rect) {
        let pixels = rectangle(area.left, area.top, area.right, area.bottom);
        self.highlights = [0; _];
        for (number, highlight) in coverage.highlights.iter().enumerate() {
            let may_be_missed =
                highlight.meets(pixels) && is_small(highlight, world.lights().len());
            self.highlights[number / 64] |= u64::from(may_be_missed) << (number % 64);
        }
        self.count = 0;
        for (number, bounds) in coverage.screen[..coverage.outlined].iter().enumerate() {
            // Branch-free: the outcome is unpredictable.
            self.outlines[self.count] = number as u16;
            self.count += usize::from(bounds.meets(rect));
        }
    }

    /// Tests highlights in `all` squares of a level, and outlines in the squares of `open`. Sets
    /// `open` to the squares that may show a feature that too few of their corners show.
    pub fn look(
        &mut self,
        squares: &Squares<'_>,
        quality: &Quality,
        all: &[Bits; TILE_HEIGHT],
        open: &mut [Bits; TILE_HEIGHT],
    ) {
        let mut search = Search {
            squares,
            open: [Bits::NONE; TILE_HEIGHT],
            light: None,
            enough: ALL,
            covered: [Covered::NONE; SQUARE_ROWS],
        };
        let mut kept = 0;
        for i in 0..self.count {
            let number = self.outlines[i];
            self.outlines[kept] = number;
            let number = usize::from(number);
            let region = squares.coverage.region(squares.world, number);
            let outline = squares.coverage.outlines[number];
            let width = squares.coverage.widths[number];
            let is_thin = 2 * usize::from(width) < THIN * squares.side();
            search.enough = if is_thin { ALL } else { 1 };
            kept += usize::from(search.look_for(outline, &region, open));
        }
        self.count = kept;
        search.settle();
        for (i, &word) in self.highlights.iter().enumerate() {
            each(word, |bit| {
                let highlight = &squares.coverage.highlights[64 * i + bit];
                search.look_for_highlight(highlight, all);
            });
        }
        let rows = squares.rows;
        open[..rows].copy_from_slice(&search.open[..rows]);
        if quality.unguarded_weight < f32::INFINITY {
            squares.look_for_unguarded(all, &mut open[..rows]);
        }
    }
}

impl Search<'_> {
    /// Tests the squares of `open` against an outline. Returns whether the outline must be tested
    /// at the next level.
    fn look_for(&mut self, outline: Outline, region: &Region, open: &[Bits; TILE_HEIGHT]) -> bool {
        let plane = |i: u8| ObjectId::new(self.squares.world.first_plane() + usize::from(i));
        // The light, and the object that corners must show: the plane, for images and shadows.
        let (light, id) = match outline {
            Outline::Object(id) => (None, id),
            Outline::Image(_) => (None, plane(0)),
            Outline::Shadow { plane: i, light, .. } => (Some(light), plane(i)),
        };
        let is_object = matches!(outline, Outline::Object(_));
        if light != self.light {
            self.settle();
            self.light = light;
        }
        let mut may_be_missed = false;
        let squares = self.squares;
        squares.for_each_row(
            region,
            open,
            #[inline(always)]
            |y, [first, last]| {
                Bits::masks(first, last, |i, mask| {
                    // Testing a square of `self.open` could only set `may_be_missed`.
                    let known = self.open[y].0[i] & u64::from(may_be_missed).wrapping_neg();
                    each(open[y].0[i] & mask & !known, |bit| {
                        let x = 64 * i + bit;
                        let shown = squares.shown(x, y, id);
                        if is_object {
                            may_be_missed |= self.look_for_object(id, shown, x, y);
                            return;
                        }
                        may_be_missed = true;
                        // If no corner shows the plane, it is hidden, or its own outline has opened
                        // the square.
                        if shown != 0 {
                            self.look_on_plane(shown, region, x, y);
                        }
                    });
                });
            },
        );
        may_be_missed
    }
}

/// The width limit of thin outlines, in halves of a square's side. A disc wider than 1.42 sides
/// contains a corner of the grid, wherever the disc is.
const THIN: usize = 3;
