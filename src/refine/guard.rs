//! The guard against what lies between corners: objects, shadows on planes, and mirror images in the first plane, that a square may
//! show although no corner does.
//!
//! Everything that can be seen has a convex outline (see `prepare::outline`), and a rectangle around that. Of hundreds of outlines
//! few have a rectangle that a tile meets. Each of these covers one range of a row of squares, which its tangents give, of four rows
//! at once: only squares in that range are looked at.
//!
//! Which object a corner shows is known from tracing it. Whether it shows a shadow or an image on a plane is not, so there the
//! outline tells: a corner that shows the plane and lies in the outline shows what has it, or what is in front of that.

use super::TILE_HEIGHT;
use super::area::Area;
use super::bits::Bits;
use super::pyramid::Pyramid;
use crate::lanes::*;
use crate::prepare::{MAX_OUTLINES, ObjectId, Prepared, Rect, SeenOutline};
use crate::scene::camera::pixels;
use crate::trace::Sample;

/// The outlines of what may be seen in a tile although no corner has shown it so far, by number.
pub(super) struct CoverageGuard {
    outlines: [u16; MAX_OUTLINES],
    count: usize,
}

/// The most that rounding moves the ends of a range, in pixels.
const MARGIN: f32 = 0.02;

/// Rows of squares that an outline is narrowed to at once.
const ROWS: usize = 4;

impl CoverageGuard {
    pub const fn new() -> Self {
        Self {
            outlines: [0; MAX_OUTLINES],
            count: 0,
        }
    }

    /// Lists the outlines that a tile, a rectangle of the picture, may show.
    pub fn begin(&mut self, scene: &Prepared, rect: Rect) {
        self.count = 0;
        for (number, bounds) in scene.screen[..scene.outlined].iter().enumerate() {
            // No branch, since it could not be predicted.
            self.outlines[self.count] = number as u16;
            self.count += usize::from(bounds.meets(rect));
        }
    }

    /// Leaves only those of a level's squares in `open` that may show something which their corners do not, and keeps the
    /// outlines of all such things for the level below: what a square is cleared of, its parts are, too.
    pub fn look_at(
        &mut self,
        scene: &Prepared,
        area: &Area,
        pyramid: &Pyramid,
        level: usize,
        open: &mut [Bits; TILE_HEIGHT],
    ) {
        let rows = area.rows(level);
        let grid = Grid::new(scene, area, pyramid, level);
        let mut uncovered = [Bits::NONE; TILE_HEIGHT];
        let mut kept = 0;
        for i in 0..self.count {
            let number = self.outlines[i];
            let outline = &scene.outline(number.into());
            let object = scene.outlined_object(number.into());
            let is_on_plane = object.index() != usize::from(number);
            let mut is_kept = false;
            for top in (0..rows).step_by(ROWS) {
                let group = top..rows.min(top + ROWS);
                if open[group.clone()].iter().all(Bits::is_empty) {
                    continue;
                }
                let [first, last] = grid.ranges(outline, top);
                for (row, y) in group.enumerate() {
                    open[y].for_each_in(first[row], last[row], |x| {
                        let (corners, shown) = grid.corners(x, y, object);
                        let is_covered = if is_on_plane {
                            // Where no corner shows the plane of a shadow or an image it cannot be seen, or is looked for itself.
                            shown == 0 || shown & grid.inside(x, y, outline) != 0
                        } else {
                            shown != 0 || grid.are_before(corners, object)
                        };
                        if !is_covered {
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
        open[..rows].copy_from_slice(&uncovered[..rows]);
    }
}

/// The squares of a level.
struct Grid<'a> {
    scene: &'a Prepared,
    area: &'a Area,
    pyramid: &'a Pyramid,
    level: usize,
    side: usize,
    columns: usize,
    /// How many columns and rows of its points are pixels of the picture.
    pixels: [usize; 2],
}

impl<'a> Grid<'a> {
    fn new(scene: &'a Prepared, area: &'a Area, pyramid: &'a Pyramid, level: usize) -> Self {
        let side = area.side(level);
        Self {
            scene,
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
    fn ranges(&self, outline: &SeenOutline<'_>, top: usize) -> [[i32; ROWS]; 2] {
        let simd = baseline();
        let Area { left, top: y, .. } = *self.area;
        let size = [self.columns * self.side, self.side];
        let rects = self
            .scene
            .axes
            .rects(simd, [left, y + top * self.side], size);
        let [from, to] = outline.narrow(rects);
        let [first, last] = [(from, -MARGIN), (to, MARGIN)].map(|(u, margin)| {
            let column = self.scene.axes.column::<Baseline>(u) - (pixels(left) - margin);
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

    /// Whether corners with some labels all show one object, which is in front of another one.
    #[inline(always)]
    fn are_before(&self, [front, others @ ..]: [usize; 4], object: ObjectId) -> bool {
        front != 0 && others == [front; 3] && self.scene.occludes(ObjectId::new(front - 1), object)
    }

    /// A bit for each corner of the square (x, y) that is inside of an outline.
    #[inline(always)]
    fn inside(&self, x: usize, y: usize, outline: &SeenOutline<'_>) -> u64 {
        let [left, right] = [x, x + 1].map(|x| pixels(self.area.left + x * self.side));
        let [top, bottom] = [y, y + 1].map(|y| pixels(self.area.top + y * self.side));
        let simd = baseline();
        let x = F::<Baseline>::simd_from(simd, [left, right, left, right]);
        let y = F::<Baseline>::simd_from(simd, [top, top, bottom, bottom]);
        let points = self.scene.axes.points::<Baseline>(x, y);
        outline.contains::<Baseline>(points).to_bitmask()
    }
}
