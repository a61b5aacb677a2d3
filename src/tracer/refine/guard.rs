//! The guard against what lies between corners: objects, shadows on planes, and mirror images in the first plane, that a square may
//! show although no corner does.
//!
//! Everything that can be seen has a convex outline (see `prepare::outline`), and a rectangle around that. Of hundreds of outlines
//! few have a rectangle that a tile meets. Each of these covers one range of a row of squares, which its tangents give, of four rows
//! at once: only squares in that range are looked at.
//!
//! Which object a corner shows is known from tracing it. Whether it shows a shadow or an image on a plane is not, so there the
//! outline tells: a corner that shows the plane and lies in the outline shows what has it, or what is in front of that.
//!
//! Corners that all are in shadow say nothing of light between two shadows, nor those that all show images of what is between two
//! images: a square is left open where two outlines hold some of its corners each, but not all. Where one holds all of them, which is
//! convex, no other by the same lamp matters.

use super::area::Area;
use super::bits::Bits;
use super::pyramid::Pyramid;
use crate::lanes::*;
use crate::picture::TILE_HEIGHT;
use crate::prepare::{
    Highlight, MAX_HIGHLIGHTS, MAX_OUTLINES, ObjectId, Rect, SeenOutline, World, rectangle,
};
use crate::scene::camera::pixels;
use crate::trace::Sample;
use glam::Vec3A;

/// The outlines of what may be seen in a tile although no corner has shown it so far, by number.
pub(super) struct CoverageGuard {
    outlines: [u16; MAX_OUTLINES],
    count: usize,
    /// The highlights that may be seen in the tile, a bit each.
    highlights: [u64; MAX_HIGHLIGHTS.div_ceil(64)],
}

/// The most that rounding moves the ends of a range, in pixels.
const COLUMN_MARGIN: f32 = 0.02;

/// All corners of a square.
const ALL: u64 = 0b1111;

/// The most rows of squares in a tile: each is larger than a pixel.
const SQUARE_ROWS: usize = TILE_HEIGHT / 2;

/// Rows of squares that an outline is narrowed to at once.
const ROWS: usize = 4;

impl CoverageGuard {
    pub const fn new() -> Self {
        Self {
            outlines: [0; MAX_OUTLINES],
            count: 0,
            highlights: [0; _],
        }
    }

    /// Lists the outlines and the highlights that a tile, a rectangle of the picture, may show.
    pub fn begin(&mut self, world: World<'_>, area: &Area, rect: Rect) {
        let pixels = rectangle(area.left, area.top, area.right, area.bottom);
        self.highlights = [0; _];
        for (number, highlight) in world.highlights().iter().enumerate() {
            self.highlights[number / 64] |= u64::from(highlight.meets(pixels)) << (number % 64);
        }
        self.count = 0;
        for (number, bounds) in world.screen[..world.outlined].iter().enumerate() {
            // No branch, since it could not be predicted.
            self.outlines[self.count] = number as u16;
            self.count += usize::from(bounds.meets(rect));
        }
    }

    /// Leaves only those of a grid's squares in `open` that may show something which their corners do not, and keeps the
    /// outlines of all such things for the level below: what a square is cleared of, its parts are, too.
    pub fn look_at(
        &mut self,
        grid: &Grid<'_>,
        squares: &[Bits; TILE_HEIGHT],
        open: &mut [Bits; TILE_HEIGHT],
    ) {
        let &Grid { world, level, .. } = grid;
        let rows = grid.area.rows(level);
        let mut uncovered = [Bits::NONE; TILE_HEIGHT];
        let mut seen_from = Vec3A::ZERO;
        let mut held = [Held::NONE; SQUARE_ROWS];
        let mut kept = 0;
        // Look for objects, shadows and images, outline by outline.
        for i in 0..self.count {
            let number = self.outlines[i];
            let outline = &world.outline(number.into());
            let object = outline.shown_by;
            let is_on_plane = object.index() != usize::from(number);
            let is_image = usize::from(number) < world.first_shadow;
            let mut is_kept = false;
            if outline.seen_from != seen_from {
                leave_open(&mut held, &mut uncovered);
                seen_from = outline.seen_from;
            }
            // Of each row take the squares that the outline meets.
            for top in (0..rows).step_by(ROWS) {
                let group = top..rows.min(top + ROWS);
                if open[group.clone()].iter().all(Bits::is_empty) {
                    continue;
                }
                let [first, last] = grid.ranges(outline, top);
                for (row, y) in group.enumerate() {
                    open[y].for_each_in(first[row], last[row], |x| {
                        let (corners, shown) = grid.corners(x, y, object);
                        if is_on_plane {
                            // Where no corner shows the plane it cannot be seen, or is looked for itself: then the square is open.
                            if shown != 0 {
                                let inside = shown & grid.inside(x, y, outline);
                                if inside == 0 && is_image {
                                    // It may be in front of another one.
                                    uncovered[y].set(x);
                                } else {
                                    held[y % SQUARE_ROWS].add(x, inside, shown);
                                }
                            }
                            is_kept = true;
                        } else if shown == 0 && !grid.are_before(corners, object, [x, y], outline) {
                            uncovered[y].set(x);
                            is_kept = true;
                        }
                    });
                }
            }
            self.outlines[kept] = number;
            kept += usize::from(is_kept);
        }
        self.count = kept;
        leave_open(&mut held, &mut uncovered);
        // Look for highlights in what is covered.
        for (i, &word) in self.highlights.iter().enumerate() {
            let mut rest = word;
            while rest != 0 {
                let number = 64 * i + rest.trailing_zeros() as usize;
                grid.look_for(&world.highlights()[number], squares, &mut uncovered);
                rest &= rest - 1;
            }
        }
        open[..rows].copy_from_slice(&uncovered[..rows]);
    }
}

/// Leaves those squares open that may show what no corner tells of, and begins with another lamp.
#[inline(never)]
fn leave_open(held: &mut [Held; SQUARE_ROWS], open: &mut [Bits; TILE_HEIGHT]) {
    for (held, open) in held.iter_mut().zip(open) {
        *open |= held.open & !held.all;
        *held = Held::NONE;
    }
}

/// What the shadows by one lamp, or all images, hold of the corners of a row of squares, a bit for each square.
#[derive(Clone, Copy)]
struct Held {
    /// One holds all of them.
    all: Bits,
    /// One holds some of those that show the plane.
    some: Bits,
    /// One may be seen, or light between two, though no corner tells.
    open: Bits,
}

impl Held {
    const NONE: Self = Self {
        all: Bits::NONE,
        some: Bits::NONE,
        open: Bits::NONE,
    };

    /// Takes in a shadow or an image that meets a square, and the corners which that holds of those that show the plane.
    #[inline(always)]
    fn add(&mut self, x: usize, corners: u64, shown: u64) {
        if corners == ALL {
            self.all.set(x);
        } else if corners == 0 || corners != shown && self.some.has(x) {
            self.open.set(x);
        } else if corners != shown {
            self.some.set(x);
        }
    }
}

/// The squares of a level.
pub(super) struct Grid<'a> {
    world: World<'a>,
    area: &'a Area,
    pyramid: &'a Pyramid,
    level: usize,
    side: usize,
    columns: usize,
    /// How many columns and rows of its points are pixels of the picture.
    pixels: [usize; 2],
}

impl<'a> Grid<'a> {
    pub fn new(world: World<'a>, area: &'a Area, pyramid: &'a Pyramid, level: usize) -> Self {
        let side = 1 << level;
        Self {
            world,
            area,
            pyramid,
            level,
            side,
            columns: area.columns(level),
            pixels: [
                (area.picture[0] - area.left).div_ceil(side),
                (area.picture[1] - area.top).div_ceil(side),
            ],
        }
    }

    /// The first and the last square, sides included, that may show what has an outline, of each of some rows from `top`
    /// down; the first beyond the last where none may.
    #[inline(never)]
    fn ranges(&self, outline: &SeenOutline, top: usize) -> [[i32; ROWS]; 2] {
        let simd = baseline();
        let Area { left, top: y, .. } = *self.area;
        let size = [self.columns * self.side, self.side];
        let rects = self
            .world
            .axes
            .rects(simd, [left, y + top * self.side], size);
        let [from, to] = outline.narrow(rects);
        let [first, last] = [(from, -COLUMN_MARGIN), (to, COLUMN_MARGIN)].map(|(u, margin)| {
            let column = self.world.axes.column::<Baseline>(u) - (pixels(left) - margin);
            let square = column / pixels(self.side);
            let square = square.max(splat(simd, 0.0));
            square
                .min(splat(simd, pixels(self.columns - 1)))
                .to_int::<I<Baseline>>()
        });
        let last = from
            .simd_le(to)
            .select(last, I::<Baseline>::splat(simd, -1));
        [first, last].map(|squares| squares.into())
    }

    /// Leaves those squares open that may show a highlight which none of their corners does.
    fn look_for(
        &self,
        highlight: &Highlight,
        squares: &[Bits; TILE_HEIGHT],
        open: &mut [Bits; TILE_HEIGHT],
    ) {
        let Area { left, top, .. } = *self.area;
        let is_even = highlight.is_even(self.side);
        let [least, most] = highlight.ends([left, top].map(pixels));
        let square =
            |place: f32, count: usize| ((place / pixels(self.side)) as i32).min(count as i32 - 1);
        let [first, last] = [least.x.max(0.0), most.x].map(|x| square(x, self.columns));
        let rows = [least.y.max(0.0), most.y].map(|y| square(y, self.area.rows(self.level)));
        for y in rows[0]..=rows[1] {
            let y = y as usize % TILE_HEIGHT;
            let closed = squares[y] & !open[y];
            closed.for_each_in(first, last, |x| {
                let (_, shown) = self.corners(x, y, highlight.object);
                if shown == 0 || shown == ALL && is_even {
                    return;
                }
                let (left, top) = (left + x * self.side, top + y * self.side);
                let rect = rectangle(left, top, left + self.side, top + self.side);
                if highlight.is_missed(rect, shown) {
                    open[y].set(x);
                }
            });
        }
    }

    /// The labels of the corners of the square (x, y), and a bit for each that is a pixel of the picture and shows an object.
    #[inline(always)]
    fn corners(&self, x: usize, y: usize, object: ObjectId) -> ([usize; 4], u64) {
        let labels = self.pyramid.corners(self.level, x, y).map(Sample::label);
        let [upper, right, lower, last] =
            labels.map(|label| u64::from(label == object.index() + 1));
        // The first one always is a pixel.
        let mut shown = upper | right << 1 | lower << 2 | last << 3;
        if x + 1 == self.pixels[0] {
            shown &= 0b0101;
        }
        if y + 1 == self.pixels[1] {
            shown &= 0b0011;
        }
        (labels, shown)
    }

    /// Whether the corners of the square (x, y), which have some labels, all show one object, which is in front of another one.
    ///
    /// It is if all of them would show a plane otherwise: then what they see of it, and all between, is on the eye's side.
    #[inline(always)]
    fn are_before(
        &self,
        [front, others @ ..]: [usize; 4],
        object: ObjectId,
        [x, y]: [usize; 2],
        outline: &SeenOutline,
    ) -> bool {
        if front == 0 || others != [front; 3] {
            return false;
        }
        let front = ObjectId::new(front - 1);
        self.world.occludes(front, object)
            || self.world.may_part(front, object) && self.inside(x, y, outline) == ALL
    }

    /// A bit for each corner of the square (x, y) that is inside of an outline. Not inlined, since that takes fewer bytes.
    #[inline(never)]
    fn inside(&self, x: usize, y: usize, outline: &SeenOutline) -> u64 {
        let [left, right] = [x, x + 1].map(|x| pixels(self.area.left + x * self.side));
        let [top, bottom] = [y, y + 1].map(|y| pixels(self.area.top + y * self.side));
        let simd = baseline();
        let x = F::<Baseline>::simd_from(simd, [left, right, left, right]);
        let y = F::<Baseline>::simd_from(simd, [top, top, bottom, bottom]);
        let points = self.world.axes.points::<Baseline>(x, y);
        outline.contains::<Baseline>(points).to_bitmask()
    }
}
