//! Draws a band, the first phase of a frame.

mod edges;
mod method;
mod patterned;
pub(super) mod points;
mod state;

use crate::coverage::rectangle;
use crate::grid::{Area, Bits, Pyramid};
use crate::maths::to_f32;
use crate::observe::{Fill, Observer, Split};
use crate::picture::{Band, CELL, TILE_HEIGHT, TILE_WIDTH};
use crate::refine::Context;
use crate::refine::fill::Run;
use crate::refine::guard::Squares;
use crate::refine::verdict::{Verdict, limits};
use crate::refine::worker::Worker;
use crate::trace::{BATCH, Sample};
use patterned::patterned_object;
use state::Tile;

pub(crate) fn draw<O: Observer>(
    context: &Context<'_, O>,
    worker: &mut Worker,
    band: &mut Band<'_>,
) {
    let Context { plan, coverage, .. } = context;
    worker.batch.begin();
    band.rough.fill([u64::MAX; _]);
    let bottom = band.top + band.height();
    let square = plan.quality.square;
    let width = if square == 1 { BATCH / TILE_HEIGHT } else { TILE_WIDTH };
    for left in (0..band.width).step_by(width) {
        let area = Area {
            left,
            top: band.top,
            right: band.width.min(left + width),
            bottom,
            picture: plan.size,
        };
        let rect = coverage.axes.rect(rectangle(
            area.left,
            area.top,
            area.right.next_multiple_of(square),
            area.bottom.next_multiple_of(square),
        ));
        let mut tile = Tile {
            context,
            visible: coverage.visible_groups(rect),
            area,
            crowding: 0.0,
            rect,
            worker: &mut *worker,
            band: &mut *band,
        };
        tile.draw();
    }
    // Around the wedge of a fold, pixels are stale.
    for (row, rough) in band.rough.iter_mut().enumerate() {
        let mut start = plan.fold.start(band.top / CELL + row, 0);
        for word in rough {
            *word &= u64::MAX.checked_shl(start as u32).unwrap_or(0);
            start = start.saturating_sub(TILE_WIDTH / CELL);
        }
    }
}

impl<O: Observer> Tile<'_, '_, O> {
    pub fn draw(&mut self) {
        let Context { plan, world, coverage, .. } = self.context;
        let top = plan.quality.top_level();
        let (columns, rows) = (self.area.columns(top), self.area.rows(top));
        let marks = &mut self.worker.marks;
        for (y, row) in marks.squares[top][..rows].iter_mut().enumerate() {
            let first = (self.area.top + (y << top)) / CELL;
            let cells = first..first + (1 << top).max(CELL) / CELL;
            let start = cells.map(|row| plan.fold.start(row, 1)).min().unwrap_or(0) * CELL;
            let hidden = start.saturating_sub(self.area.left) >> top;
            *row = Bits::below(columns).without(Bits::below(hidden));
        }
        if marks.squares[top][..rows].iter().all(Bits::is_empty) {
            return;
        }
        if plan.quality.guarded && top > 0 {
            self.worker.guard.begin(*world, coverage, &self.area, self.rect);
            marks.open[top] = marks.squares[top];
        } else {
            marks.open[top][..rows].fill(Bits::NONE);
        }
        for level in (1..=top).rev() {
            self.find_points(level, level == top);
            if plan.quality.guarded {
                let worker = &mut *self.worker;
                let squares = Squares::new(*world, coverage, &self.area, &worker.pyramid, level);
                let (all, open) = (&worker.marks.squares[level], &mut worker.marks.open[level]);
                worker.guard.look(&squares, &plan.quality, all, open);
            }
            let rows = self.area.rows(level);
            let mut split = [Bits::NONE; 3];
            for y in 0..=rows {
                let below = if y < rows { self.fill_row(level, y) } else { Bits::NONE };
                split = [split[1], split[2], below];
                if y > 0 {
                    self.split_row(level, y - 1, &split);
                }
            }
            if level == top {
                self.crowding = self.crowding(top);
            }
        }
        self.find_points(0, top == 0);
        if plan.quality.guarded {
            self.follow_edges();
        }
        if top > 0 {
            self.show_method();
        }
    }

    fn crowding(&self, top: usize) -> f32 {
        let rows = self.area.rows(top);
        let [mut filled, mut all] = [0; 2];
        for y in 0..rows {
            self.worker.marks.filled[top][y].for_each(|_| filled += 1);
            self.worker.marks.squares[top][y].for_each(|_| all += 1);
        }
        let split = 1.0 - to_f32(filled) / to_f32(all);
        let square = split * split;
        square * square
    }

    /// Returns the squares that the verdict splits. Not inlined, like [`Tile::split_row`]: 175
    /// packed bytes less.
    #[inline(never)]
    fn fill_row(&mut self, level: usize, y: usize) -> Bits {
        let Context { plan, kernels, .. } = self.context;
        let side = 1 << level;
        let marks = &mut self.worker.marks;
        let is_coarse = plan.coarse >= side;
        if is_coarse {
            marks.open[level][y] = Bits::NONE;
        }
        let squares = marks.squares[level][y].without(marks.open[level][y]);
        let mut verdict = if is_coarse {
            Verdict::coarse(squares)
        } else {
            let pyramid = &self.worker.pyramid;
            let (above, below) = (pyramid.row(level, y), pyramid.row(level, y + 1));
            let limits = limits(&plan.quality, self.growth(level));
            (kernels.judge)(kernels.level, limits, &squares, above, below)
        };
        let patterned = self.fill_patterned(level, y, &mut verdict);
        self.fill_squares(level, y, &verdict);
        if O::LISTENS {
            let open = self.worker.marks.squares[level][y].without(squares);
            self.report_split(level, y, open, Split::Uncovered);
            let split = squares.without(verdict.filled | patterned);
            self.report_split(level, y, split & verdict.agreeing, Split::Colours);
            self.report_split(level, y, split.without(verdict.agreeing), Split::Keys);
        }
        let filled = verdict.filled | patterned;
        self.worker.marks.filled[level][y] = filled;
        if side == CELL {
            self.note_rough(level, y, verdict.filled);
        }
        squares.without(filled)
    }

    /// Marks the rough cells of a row. Interpolated squares of the largest size are smooth:
    /// adjacent pixels differ by at most an eighth of the tolerance, plus 2 for rounding and
    /// dither.
    fn note_rough(&mut self, level: usize, y: usize, filled: Bits) {
        let plan = self.context.plan;
        let quality = &plan.quality;
        let tolerance = quality.tolerance_agreeing.max(quality.tolerance_differing);
        let is_smooth = tolerance / CELL as f32 + 2.0 < f32::from(quality.edge);
        if quality.square == CELL && is_smooth && plan.coarse < 2 {
            let squares = &self.worker.marks.squares[level][y];
            self.band.rough[y][self.area.left / TILE_WIDTH] = squares.0[0] & !filled.0[0];
        }
    }

    fn fill_squares(&mut self, level: usize, y: usize, verdict: &Verdict) {
        let pyramid = &self.worker.pyramid;
        let run = Run {
            x: self.area.left,
            y: y << level,
            level,
            above: pyramid.row(level, y).samples,
            below: pyramid.row(level, y + 1).samples,
            filled: verdict.filled,
            flat: verdict.flat,
            dither: &self.context.world.film.dither,
        };
        let kernels = &self.context.kernels;
        (kernels.fill)(kernels.level, self.band, &run);
    }

    /// Splits filled squares between two squares split by the verdict: a thin line between equal
    /// corners would pop. This halves the pops of letters on water. `above`, `here` and `below` are
    /// the squares that the verdict split in three rows.
    fn open_gaps(&mut self, level: usize, y: usize, [above, here, below]: &[Bits; 3]) {
        let mut gaps = Bits::NONE;
        if self.context.plan.quality.guarded {
            for (i, gaps) in gaps.0.iter_mut().enumerate() {
                let filled = &mut self.worker.marks.filled[level][y].0[i];
                let beside = here.0[i] << 1 & here.0[i] >> 1;
                // Gaps at the ends of 64-bit words stay filled.
                *gaps = *filled & (beside | above.0[i] & below.0[i]);
                *filled &= !*gaps;
            }
        }
        if 1 << level == CELL {
            self.band.rough[y][self.area.left / TILE_WIDTH] |= gaps.0[0];
        }
        if O::LISTENS {
            self.report_split(level, y, gaps, Split::Gap);
            self.worker.marks.filled[level][y]
                .for_each(|x| self.report(level, x, y, self.fill_of(level, x, y)));
        }
    }

    fn fill_of(&self, level: usize, x: usize, y: usize) -> Fill {
        let pyramid = &self.worker.pyramid;
        let corners = Pyramid::corner_indices(level, x, y).map(|index| pyramid.sample(index));
        let [first, others @ ..] = corners.map(|corner| corner.pixel(Sample::HALF_STEP));
        let is_coarse = self.context.plan.coarse >= 1 << level;
        if !is_coarse && patterned_object(&corners).is_some() {
            Fill::Patterned
        } else if is_coarse || others == [first; 3] {
            Fill::Flat
        } else {
            Fill::Bilinear
        }
    }

    /// Marks the parts of a row's unfilled squares, inside the picture.
    #[inline(never)]
    fn split_row(&mut self, level: usize, y: usize, judged: &[Bits; 3]) {
        self.open_gaps(level, y, judged);
        let part = level - 1;
        let (columns, rows) = (self.area.columns(part), self.area.rows(part));
        let marks = &mut self.worker.marks;
        let split = marks.squares[level][y].without(marks.filled[level][y]);
        let (mut squares, mut open) = (Bits::NONE, Bits::NONE);
        if !split.is_empty() {
            squares = split.halves() & Bits::below(columns);
            open = marks.open[level][y].halves() & Bits::below(columns);
        }
        for row in 2 * y..rows.min(2 * y + 2) {
            marks.squares[part][row] = squares;
            marks.open[part][row] = open;
        }
        if O::LISTENS && part == 0 {
            split.for_each(|x| self.report(level, x, y, Fill::Points));
        }
    }

    fn report_split(&self, level: usize, y: usize, squares: Bits, why: Split) {
        let [left, top] = [self.area.left, self.area.top + (y << level)];
        let observer = self.context.observer;
        squares.for_each(|x| observer.split(left + (x << level), top, 1 << level, why));
    }

    fn report(&self, level: usize, x: usize, y: usize, fill: Fill) {
        let side = 1 << level;
        let (x, y) = (self.area.left + x * side, self.area.top + y * side);
        self.context.observer.square(x, y, side, side, fill);
    }
}
