//! Finds the squares of a tile that may show something between their corners.
//!
//! A tile meets few of the outlines. Tangents give the range of squares that an outline covers in each row, for four rows at once.
//! Tracing gives the object at a corner, but not the shadows and images there. For these the guard tests whether a corner that
//! shows the plane is inside the outline: it then shows the shadow or image, or an occluder of it.

use super::highlight::MAX_HIGHLIGHTS;
use super::screen::{Rect, corners};
use super::sides::Region;
use super::{Coverage, MAX_OUTLINES, Outline, rectangle};
use crate::grid::{Area, Bits, Pyramid, each};
use crate::lanes::*;
use crate::picture::TILE_HEIGHT;
use crate::prepare::{ObjectId, World};
use crate::quality::Quality;
use crate::rounding::COLUMN;
use crate::scene::camera::pixels;
use crate::trace::{Sample, seen_points};
use fearless_simd::u32x4;
use glam::Vec4;

/// A tile's highlights, and the outlines that its next level has to test.
pub(crate) struct Guard {
    outlines: [u16; MAX_OUTLINES],
    count: usize,
    highlights: [u64; MAX_HIGHLIGHTS.div_ceil(64)],
}

impl Guard {
    pub const fn new() -> Self {
        Self { outlines: [0; MAX_OUTLINES], count: 0, highlights: [0; _] }
    }

    pub fn begin(&mut self, coverage: &Coverage, area: &Area, rect: Rect) {
        let pixels = rectangle(area.left, area.top, area.right, area.bottom);
        self.highlights = [0; _];
        for (number, highlight) in coverage.highlights.iter().enumerate() {
            self.highlights[number / 64] |= u64::from(highlight.meets(pixels)) << (number % 64);
        }
        self.count = 0;
        for (number, bounds) in coverage.screen[..coverage.outlined].iter().enumerate() {
            // Branch-free: the outcome is unpredictable.
            self.outlines[self.count] = number as u16;
            self.count += usize::from(bounds.meets(rect));
        }
    }

    /// Sets `open` to the squares of a level that may show something that their corners do not: tests outlines in the squares that were
    /// open, highlights in `all` squares of the level.
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

/// The state of a search through a level's squares.
pub(super) struct Search<'a> {
    pub squares: &'a Squares<'a>,
    pub open: [Bits; TILE_HEIGHT],
    light: Option<u8>,
    /// The least corner mask that clears a square: 1 (any corner), or [`ALL`] for a thin outline.
    enough: u64,
    /// The corners that this light's shadows, or images, cover in each row of squares.
    covered: [Covered; SQUARE_ROWS],
}

impl Search<'_> {
    /// Tests the open squares against an outline. Returns whether their parts have to be tested.
    fn look_for(&mut self, outline: Outline, region: &Region, open: &[Bits; TILE_HEIGHT]) -> bool {
        let plane = |i: u8| ObjectId::new(self.squares.world.first_plane() + usize::from(i));
        // The light, and the object or the plane that shows the image or shadow.
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
                    // If the parts are to be tested anyway, open squares need no test.
                    let known = self.open[y].0[i] & u64::from(may_be_missed).wrapping_neg();
                    each(open[y].0[i] & mask & !known, |bit| {
                        let x = 64 * i + bit;
                        let shown = squares.shown(x, y, id);
                        if is_object {
                            may_be_missed |= self.look_for_object(id, shown, x, y);
                            return;
                        }
                        may_be_missed = true;
                        // Otherwise the plane is hidden, or its own outline has opened the square.
                        if shown != 0 {
                            self.look_on_plane(shown, region, x, y);
                        }
                    });
                });
            },
        );
        may_be_missed
    }

    /// Opens a square unless a corner shows the object (all corners, if it is thin) or an occluder hides it. Returns whether it was opened.
    fn look_for_object(&mut self, id: ObjectId, shown: u64, x: usize, y: usize) -> bool {
        let labels = self.squares.labels(x, y);
        let is_same = labels.simd_eq(labels[0]).all_true();
        let is_missed =
            shown < self.enough && !(shown == 0 && is_same && self.is_hidden(id, labels[0], x, y));
        if is_missed {
            self.open[y].set(x);
        }
        is_missed
    }

    /// Returns whether the object `back` is hidden in a square whose corners all have the label `front`.
    ///
    /// Occluders are convex: if the eye is outside, everything that the square shows in front of the occluder lies in the pyramid of the
    /// eye and the corners' points. A plane that separates `back` from the pyramid proves that it is hidden.
    #[inline(never)]
    fn is_hidden(&self, back: ObjectId, front: u32, x: usize, y: usize) -> bool {
        let &Squares { world, coverage, .. } = self.squares;
        if front == 0 || front as usize > world.background() {
            return false;
        }
        let front = ObjectId::new(front as usize - 1);
        if coverage.has_less_power(front, back) {
            return true;
        }
        let points = || {
            let places = corners(self.squares.pixels(x, y));
            let (d, t) = seen_points(world, &world.object(front).0, places);
            [d.x * t, d.y * t, d.z * t, t]
        };
        let [front, back] = [front, back].map(|id| &coverage.objects[id.index()]);
        let eye = world.eye.extend(0.0);
        front.excludes(eye) && back.is_beyond(front, eye, points)
    }

    /// Tests an image or shadow on a plane that some corners show. An image opens the square unless such a corner (all four, if it is thin)
    /// is inside the region. If all corners show the plane and one side of the region cuts the square, one of them is inside: a half-plane
    /// that meets a square contains a corner. If an object hides the other corners, one that shows the plane has to be outside, too. Shadows
    /// wait for [`Search::settle`], since another one may cover the square.
    fn look_on_plane(&mut self, shown: u64, region: &Region, x: usize, y: usize) {
        let rect = self.squares.coverage.axes.rect(self.squares.pixels(x, y));
        let cuts = region.sides.cuts(rect, region.margin);
        let is_cut_once = cuts == 1 && shown == ALL;
        let inside = match cuts {
            0 => ALL,
            // Any one corner.
            _ if is_cut_once => 1,
            _ => region.corners(rect),
        };
        let covered = &mut self.covered[y % SQUARE_ROWS];
        // Where an object hides the other corners, the plane may show between the object and the outline.
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

    /// Opens the squares that may miss a shadow from the current light, an image, or a slit between two of them.
    #[inline(never)]
    fn settle(&mut self) {
        let rows = self.squares.rows;
        for (covered, open) in self.covered[..rows].iter_mut().zip(&mut self.open) {
            *open |= covered.missed.without(covered.wholly);
            *covered = Covered::NONE;
        }
    }
}

const SQUARE_ROWS: usize = TILE_HEIGHT / 2;

/// The width limit of thin outlines, in halves of a square's side. An outline wider than a side covers a corner; the other half is for
/// partly hidden ones.
const THIN: usize = 3;

pub(super) const ALL: u64 = 0b1111;

/// How the shadows of one light, or the images, cover the corners of a row of squares.
///
/// A square stays open if two outlines each cover some corners: something may lie between them. An outline that covers all corners covers
/// the square, as it is convex.
#[derive(Clone, Copy)]
struct Covered {
    /// One outline covers all corners.
    wholly: Bits,
    /// One outline covers some corners that show the plane.
    partly: Bits,
    /// An outline covers no corner that shows the plane, or two outlines each cover some.
    missed: Bits,
}

impl Covered {
    const NONE: Self = Self { wholly: Bits::NONE, partly: Bits::NONE, missed: Bits::NONE };
}

pub(crate) struct Squares<'a> {
    pub(super) world: World<'a>,
    pub(super) coverage: &'a Coverage,
    pub(super) area: &'a Area,
    /// The samples of the corners, row by row.
    pub(super) grid: &'a [u64],
    pub(super) stride: usize,
    pub(super) level: usize,
    pub(super) columns: usize,
    pub(super) rows: usize,
    /// Columns and rows of corners inside the picture.
    inside: [usize; 2],
    /// The first square's corners, in pixels.
    first: Vec4,
}

/// Rows that a region is clipped to at once.
const ROWS: usize = 4;

impl<'a> Squares<'a> {
    pub fn new(
        world: World<'a>,
        coverage: &'a Coverage,
        area: &'a Area,
        pyramid: &'a Pyramid,
        level: usize,
    ) -> Self {
        let side = 1 << level;
        Self {
            world,
            coverage,
            area,
            grid: pyramid.grid(level),
            stride: Pyramid::stride(level),
            level,
            columns: area.columns(level),
            rows: area.rows(level),
            first: rectangle(area.left, area.top, area.left + side, area.top + side),
            inside: [
                (area.picture[0] - area.left).div_ceil(side),
                (area.picture[1] - area.top).div_ceil(side),
            ],
        }
    }

    pub(super) fn side(&self) -> usize {
        1 << self.level
    }

    /// Calls `call` with the rows of squares that a region may meet, and the first and last square.
    #[inline(always)]
    fn for_each_row(
        &self,
        region: &Region,
        open: &[Bits; TILE_HEIGHT],
        mut call: impl FnMut(usize, [i32; 2]),
    ) {
        for top in (0..self.rows).step_by(ROWS) {
            let group = top..self.rows.min(top + ROWS);
            if open[group.clone()].iter().all(Bits::is_empty) {
                continue;
            }
            let [first, last] = self.ranges(region, top);
            for (row, y) in group.enumerate() {
                call(y, [first[row], last[row]]);
            }
        }
    }

    /// Returns the first and last square of each of [`ROWS`] rows from `top` down that may meet a region; first > last for none.
    #[inline(never)]
    fn ranges(&self, region: &Region, top: usize) -> [[i32; ROWS]; 2] {
        let simd = baseline();
        let axes = &self.coverage.axes;
        let corner = [self.area.left, self.area.top + (top << self.level)];
        let size = [self.columns << self.level, self.side()];
        let [from, to] = region.narrow(axes.rects(simd, corner, size));
        let [first, last] = [(from, -COLUMN), (to, COLUMN)].map(|(u, margin)| {
            let column = axes.column::<Baseline>(u) - (pixels(self.area.left) - margin);
            let square = column / pixels(self.side());
            let square = square.max(splat(simd, 0.0));
            square.min(splat(simd, pixels(self.columns - 1))).to_int::<I<Baseline>>()
        });
        let last = from.simd_le(to).select(last, I::<Baseline>::splat(simd, -1));
        [first, last].map(|squares| squares.into())
    }

    #[inline(always)]
    fn labels(&self, x: usize, y: usize) -> u32x4<Baseline> {
        let start = y * self.stride + x;
        Sample::labels(&self.grid[start..start + self.stride + 2])
    }

    /// Returns a bit for each corner of a square that is inside the picture and shows an object.
    #[inline(always)]
    pub(super) fn shown(&self, x: usize, y: usize, object: ObjectId) -> u64 {
        let label = object.index() as u32 + 1;
        let mut shown = self.labels(x, y).simd_eq(label).to_bitmask();
        // The first corner is always inside.
        if x + 1 == self.inside[0] {
            shown &= 0b0101;
        }
        if y + 1 == self.inside[1] {
            shown &= 0b0011;
        }
        shown
    }

    /// Returns the corners of a square in pixels.
    #[inline(always)]
    pub(super) fn pixels(&self, x: usize, y: usize) -> Vec4 {
        let [x, y] = [x << self.level, y << self.level];
        self.first + rectangle(x, y, x, y)
    }
}
