//! The squares of one level of a tile, with the samples at their corners.

use crate::coverage::{Coverage, Region, rectangle};
use crate::grid::{Area, Bits, Pyramid};
use crate::lanes::*;
use crate::maths::to_f32;
use crate::picture::TILE_HEIGHT;
use crate::prepare::{ObjectId, World};
use crate::rounding::COLUMN;
use crate::trace::Sample;
use fearless_simd::u32x4;
use glam::Vec4;

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

/// The number of rows that `Squares::ranges` tests at once.
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

    /// Calls `call` with each row near open squares, and its first and last square that a region
    /// may meet.
    #[inline(always)]
    pub(super) fn for_each_row(
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

    /// Returns the first and last square that may meet a region, for each of [`ROWS`] rows from
    /// `top` down. In an empty range the first exceeds the last.
    #[inline(never)]
    fn ranges(&self, region: &Region, top: usize) -> [[i32; ROWS]; 2] {
        let simd = baseline();
        let axes = &self.coverage.axes;
        let corner = [self.area.left, self.area.top + (top << self.level)];
        let size = [self.columns << self.level, self.side()];
        let [from, to] = region.clip(axes.rects(simd, corner, size));
        let [first, last] = [(from, -COLUMN), (to, COLUMN)].map(|(u, margin)| {
            let column = axes.column::<Baseline>(u) - (to_f32(self.area.left) - margin);
            let square = column / to_f32(self.side());
            let square = square.max(splat(simd, 0.0));
            square.min(splat(simd, to_f32(self.columns - 1))).to_int::<I<Baseline>>()
        });
        let last = from.simd_le(to).select(last, I::<Baseline>::splat(simd, -1));
        [first, last].map(Into::into)
    }

    #[inline(always)]
    pub(super) fn labels(&self, x: usize, y: usize) -> u32x4<Baseline> {
        let start = y * self.stride + x;
        Sample::labels(&self.grid[start..start + self.stride + 2])
    }

    /// Returns the mask of a square's corners that are inside the picture and show `object`.
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
