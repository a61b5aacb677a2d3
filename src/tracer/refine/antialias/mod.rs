//! Antialiasing, the second phase of a frame: blends pixels at edges with points between them.
//!
//! If two neighbouring pixels differ by an edge, the midpoint between them is traced, once for
//! both. Then each pixel bisects the interval from its centre to the midpoint. If its ends differ
//! by `HALF`, the point between them is traced. If that point differs from an end by `QUARTER`, a
//! point between these two is traced, and from twice that difference on a third.
//!
//! ```text
//!     a          midpoint         b
//!   +---------------+---------------+
//!   |               |     /         |
//!   |       x       o   o/o x       |        a and the midpoint are alike. Towards b the edge is found to an eighth.
//!   |               |   /           |
//!   +---------------+---------------+
//!                    an edge
//! ```
//!
//! Along each axis, the pixel's colour is the mean of its points by the trapezoid rule: a midpoint
//! at an edge weighs a quarter, a side without an edge has the pixel's own colour. The axis with
//! the larger change replaces the pixel: crossing the edge steeply, it measures coverage better
//! than a mean of both axes.
//!
//! Marks compare pixels before any is blended, even across bands: the bits do not depend on the
//! number of threads. Only rough cells and their borders are searched, since a filled square of 8
//! has no edges inside.

mod marks;

pub(super) use marks::is_edge;

use super::Context;
use super::bisect::{add_middle, bisect, mix_pixel};
use super::worker::{STRETCH, Worker};
use crate::coverage::rectangle;
use crate::grid::each;
use crate::picture::{Band, CELL_ROWS, MAX_BANDS, TILE_HEIGHT};
use crate::plan::FramePlan;
use crate::prepare::VisibleGroups;
use crate::trace::{BATCH, PARTS};
use crate::zero::Zero;
use marks::{EdgeMarks, MAX_STRETCHES, ROWS, RowMarks, mark, mark_stretch, rough_cells, stretch};

/// The most midpoints in a batch: bisection needs a point on each side of a midpoint.
const MAX_MIDDLES: usize = BATCH / 2;

/// Marks between each band's last row and the row below, set before any band is smoothed. (Copies
/// of the rows would take 2 MB.)
pub(crate) struct Seams([RowMarks; MAX_BANDS]);

zero! { Seams = Self(Zero::ZERO); }

impl Seams {
    /// Computes the marks of a drawn picture.
    pub fn set(&mut self, plan: &FramePlan, picture: &Band<'_>) {
        let finished = plan.finished;
        let &Band { stride, ref pixels, ref rough, .. } = picture;
        let ends = (TILE_HEIGHT * stride..pixels.len()).step_by(TILE_HEIGHT * stride);
        for (number, end) in ends.enumerate() {
            let (above, below) = (&pixels[end - stride..], &pixels[end..]);
            let next = CELL_ROWS * (number + 1);
            let rough = [&rough[next - 1], &rough[next]];
            let words = finished.div_ceil(STRETCH);
            for (word, marks) in self.0[number][..words].iter_mut().enumerate() {
                let stretch = stretch(word, finished);
                let cells = rough_cells(rough[0], word) | rough_cells(rough[1], word);
                *marks = mark(plan, &above[stretch.clone()], &below[stretch], cells);
            }
        }
    }

    pub fn smooth<O>(&self, context: &Context<'_, O>, worker: &mut Worker, band: &mut Band<'_>) {
        let number = band.top / TILE_HEIGHT;
        let is_last = band.top + band.height() == context.plan.size[1];
        // Pixels on the picture's border have no edge outward.
        let none = &[0; MAX_STRETCHES];
        let above = number.checked_sub(1).map_or(none, |above| &self.0[above]);
        let borders = [above, if is_last { none } else { &self.0[number] }];
        worker.batch.begin();
        worker.pyramid.changes().fill(0);
        let &Context { plan, coverage, .. } = context;
        let finished = plan.finished;
        let mut marks: EdgeMarks = [0; _];
        // Per row: whether an edge lies between the previous stretch and this one.
        let mut before = [0; TILE_HEIGHT];
        let (top, height) = (band.top, band.height());
        for (word, start) in (0..finished).step_by(STRETCH).enumerate() {
            mark_stretch(plan, band, word, borders, &mut marks);
            let any = marks[..=ROWS * height].iter().chain(&before).fold(0, |all, row| all | row);
            if any == 0 {
                continue;
            }
            let (left, above) = (start.saturating_sub(1), top.saturating_sub(1));
            let rect = rectangle(left, above, start + STRETCH, top + height);
            let visible = coverage.visible_groups(coverage.axes.rect(rect));
            for (number, &row) in marks[..=ROWS * height].iter().enumerate() {
                if row == 0 && (number % ROWS == 0 || before[number / ROWS] == 0) {
                    continue;
                }
                if worker.batch.points.len() + STRETCH + 1 > MAX_MIDDLES {
                    trace_middles(context, visible, start, band, worker);
                }
                let points = &mut worker.batch.points;
                let [x, y] = [ROWS * start + number % ROWS, (ROWS * top + number).wrapping_sub(1)]
                    .map(|at| at.wrapping_mul(PARTS / ROWS));
                if number % ROWS != 0 && before[number / ROWS] != 0 {
                    points.push(x - PARTS, y);
                }
                each(row, |bit| points.push(x + PARTS * bit, y));
            }
            trace_middles(context, visible, start, band, worker);
            for (y, row) in band.rows() {
                let right = marks[ROWS * y + 1];
                let along_x = right | right << 1 | before[y];
                before[y] = right >> (STRETCH - 1);
                each(along_x | marks[ROWS * y] | marks[ROWS * y + 2], |bit| {
                    mix_pixel(&mut row[start + bit], STRETCH * y + bit, worker);
                });
            }
        }
    }
}

/// Traces the batch's midpoints, adds them to the changes of the pixels in the stretch from column
/// `left`, and bisects.
#[inline(never)]
fn trace_middles<O>(
    context: &Context<'_, O>,
    visible: VisibleGroups,
    left: usize,
    band: &Band<'_>,
    worker: &mut Worker,
) {
    let plan = context.plan;
    context.trace(&plan.quality, visible, &mut worker.batch);
    for i in 0..2 * worker.batch.points.len() {
        let (point, side) = (i / 2, i % 2);
        let (x, y) = worker.batch.points.position(point);
        let axis = usize::from(x % PARTS == 0);
        let [x, y] = [x, y].map(|at| (at + (PARTS - 1) * (1 - side)) / PARTS);
        let (column, row) = (x.wrapping_sub(left), y.wrapping_sub(band.top));
        if column < STRETCH && row < band.height() {
            let drawn = band.pixels[band.stride * row + x];
            let pixel = STRETCH * row + column;
            add_middle(plan, worker, point, drawn, [x, y], pixel, 2 * axis + side);
        }
    }
    worker.batch.points.clear();
    bisect(context, &plan.quality, visible, worker);
}
