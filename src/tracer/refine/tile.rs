//! Drawing a tile: level by level its points are traced, and its squares judged, then filled or split.

use super::antialias::EDGE;
use super::fill::{Run, fill};
use super::verdict::{Rules, Verdict, growth, judge};
use super::worker::{Marks, Worker};
use crate::coverage::{Rect, Squares};
use crate::grid::{Area, Bits};
use crate::observe::{Fill, Observer, Split};
use crate::picture::{BLOCK, BLOCK_ROWS, Band};
use crate::plan::Context;
use crate::prepare::VisibleGroups;
use crate::scene::camera::pixels;
use crate::trace::Sample;
use core::array;
use core::ops::Range;

/// A tile that is being drawn.
pub(super) struct Tile<'a, 'b, O: Observer> {
    pub context: &'a Context<'a, O>,
    pub area: Area,
    /// How much of it the largest squares leave open, from 0, some, to 1, nearly all.
    pub crowding: f32,
    /// The part of the picture that its squares cover.
    pub rect: Rect,
    /// The groups that the tile can show.
    pub seen: VisibleGroups,
    pub worker: &'a mut Worker,
    /// The band that the tile is a part of.
    pub band: &'a mut Band<'b>,
}

/// The share of its largest squares that a tile splits where it begins to count as crowded, and where it is. The model scene at
/// 1024x768 has no tile that is; of a field of 256 spheres most are.
const CROWDED: Range<f32> = 0.7..0.9;

impl<O: Observer> Tile<'_, '_, O> {
    /// Draws the tile, from the largest squares down to pixels.
    pub fn draw(&mut self) {
        let Context { plan, coverage, .. } = self.context;
        let top = plan.quality.top_level();
        let (columns, rows) = (self.area.columns(top), self.area.rows(top));
        self.worker.marks.squares[top][..rows].fill(Bits::first(columns));
        let open = if plan.quality.guarded && top > 0 {
            self.worker.guard.begin(coverage, &self.area, self.rect);
            Bits::first(columns)
        } else {
            Bits::NONE
        };
        self.worker.marks.open[top][..rows].fill(open);
        for level in (1..=top).rev() {
            self.find_points(level, level == top);
            self.look_for_uncovered(level);
            for y in 0..self.area.rows(level) {
                self.fill_row(level, y);
                self.split_row(level, y);
            }
            if level == top {
                self.crowding = self.crowding(top);
            }
        }
        self.find_points(0, top == 0);
        if top > 0 {
            self.show_method();
        }
    }

    /// How crowded the tile is, by the share of the largest squares that were not filled.
    fn crowding(&self, top: usize) -> f32 {
        let (columns, rows) = (self.area.columns(top), self.area.rows(top));
        let words = self.worker.marks.filled[top][..rows]
            .iter()
            .flat_map(|row| row.0);
        let filled: u32 = words.map(u64::count_ones).sum();
        let split = 1.0 - pixels(filled as usize) / pixels(columns * rows);
        ((split - CROWDED.start) / (CROWDED.end - CROWDED.start)).clamp(0.0, 1.0)
    }

    /// The factor on tolerances for squares of 8, for those of a level.
    pub fn growth(&self, level: usize) -> f32 {
        growth(1 << level, self.crowding)
    }

    /// The tile's words of the rough blocks of its band, once it is drawn: blocks are rough unless they are the largest squares
    /// and were filled by colours between their corners'. `None` if that says nothing of edges.
    ///
    /// Between corners within a tolerance each pixel differs from the next by an eighth of it at most, and by 2 more for rounding
    /// and dither.
    pub fn rough(&self) -> Option<[u64; BLOCK_ROWS]> {
        let plan = self.context.plan;
        let quality = &plan.quality;
        let tolerance = quality.tolerance_agreeing.max(quality.tolerance_differing);
        let is_known = quality.square == BLOCK
            && tolerance / BLOCK as f32 + 2.0 < f32::from(EDGE)
            && plan.coarse == 0;
        let Marks {
            squares, smooth, ..
        } = &self.worker.marks;
        let squares = &squares[quality.top_level()];
        is_known.then(|| array::from_fn(|y| squares[y].0[0] & !smooth[y]))
    }

    /// Has the guard look at a level's squares.
    fn look_for_uncovered(&mut self, level: usize) {
        let &Context {
            plan,
            world,
            coverage,
            ..
        } = self.context;
        if plan.quality.guarded {
            let Worker {
                guard,
                marks,
                pyramid,
                ..
            } = &mut *self.worker;
            let open = &mut marks.open[level];
            let squares = Squares::new(world, coverage, &self.area, pyramid, level);
            guard.look(&squares, &marks.squares[level], open);
        }
    }

    /// Judges a row of squares, and fills those that pass.
    fn fill_row(&mut self, level: usize, y: usize) {
        let Context { plan, .. } = self.context;
        let side = 1 << level;
        let marks = &mut self.worker.marks;
        let is_coarse = plan.coarse >= side;
        if is_coarse {
            marks.open[level][y] = Bits::NONE;
        }
        let squares = marks.squares[level][y] & !marks.open[level][y];
        let open = marks.squares[level][y] & marks.open[level][y];
        self.tell_split(level, y, open, Split::Uncovered);
        if squares.is_empty() {
            self.worker.marks.filled[level][y] = Bits::NONE;
            self.set_smooth(side, y, Bits::NONE);
            return;
        }
        let pyramid = &self.worker.pyramid;
        let (above, below) = (pyramid.row(level, y), pyramid.row(level, y + 1));
        let rules = Rules::new(&plan.quality, self.growth(level));
        let mut verdict = judge(plan.isa, rules, &squares, above, below);
        if is_coarse {
            verdict = Verdict::coarse(squares);
        }
        let patterned = self.fill_patterned(level, y, &mut verdict);
        self.fill_squares(level, y, &verdict);
        if O::LISTENS {
            verdict.filled.for_each(|x| {
                let fill = if verdict.flat.has(x) {
                    Fill::Flat
                } else {
                    Fill::Bilinear
                };
                self.tell(level, x, y, fill);
            });
        }
        let split = squares & !(verdict.filled | patterned);
        self.tell_split(level, y, split & verdict.agreeing, Split::Colours);
        self.tell_split(level, y, split & !verdict.agreeing, Split::Keys);
        self.worker.marks.filled[level][y] = verdict.filled | patterned;
        self.set_smooth(side, y, verdict.filled);
    }

    /// Notes the blocks of a row that are squares filled by colours between their corners'.
    fn set_smooth(&mut self, side: usize, y: usize, filled: Bits) {
        if side == BLOCK {
            self.worker.marks.smooth[y] = filled.0[0];
        }
    }

    /// Fills the squares of a row that passed the verdict.
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
        fill(self.context.plan.isa, self.band, &run);
    }

    /// Fills those squares of a row whose corners all show one object with a pattern, if their light allows it, and returns
    /// them. They are taken out of the verdict.
    fn fill_patterned(&mut self, level: usize, y: usize, verdict: &mut Verdict) -> Bits {
        let mut filled = Bits::NONE;
        verdict.patterned.for_each(|x| {
            let corners = self.worker.pyramid.corners(level, x, y);
            let object = corners[0].object();
            if corners.iter().any(|corner| corner.object() != object) {
                return;
            }
            verdict.filled.clear(x);
            if self.fill_pattern(level, [x, y], verdict.agreeing.has(x)) {
                filled.set(x);
                self.tell(level, x, y, Fill::Patterned);
            }
        });
        filled
    }

    /// Sets the pixel (x, y), in pixels of the band, to a sample's colour.
    #[inline(always)]
    pub fn put(&mut self, x: usize, y: usize, sample: Sample) {
        let threshold = self.context.world.film.threshold(x, self.area.top + y);
        self.band.put(x, y, sample.pixel(threshold));
    }

    /// Splits a row's squares that were not filled: marks those of their parts that are in the picture.
    fn split_row(&mut self, level: usize, y: usize) {
        let part = level - 1;
        let (columns, rows) = (self.area.columns(part), self.area.rows(part));
        let marks = &mut self.worker.marks;
        let split = marks.squares[level][y] & !marks.filled[level][y];
        let (mut squares, mut open) = (Bits::NONE, Bits::NONE);
        if !split.is_empty() {
            squares = split.halves() & Bits::first(columns);
            open = marks.open[level][y].halves() & Bits::first(columns);
        }
        for row in 2 * y..rows.min(2 * y + 2) {
            marks.squares[part][row] = squares;
            marks.open[part][row] = open;
        }
        if O::LISTENS && part == 0 {
            split.for_each(|x| self.tell(level, x, y, Fill::Points));
        }
    }

    /// Tells the observer of squares of a row that are split.
    fn tell_split(&self, level: usize, y: usize, squares: Bits, why: Split) {
        if O::LISTENS {
            let [left, top] = [self.area.left, self.area.top + (y << level)];
            let observer = self.context.observer;
            squares.for_each(|x| observer.split(left + (x << level), top, 1 << level, why));
        }
    }

    /// Tells the observer of a square that has been drawn.
    fn tell(&self, level: usize, x: usize, y: usize, fill: Fill) {
        let side = 1 << level;
        let (x, y) = (self.area.left + x * side, self.area.top + y * side);
        self.context.observer.square(x, y, side, side, fill);
    }
}
