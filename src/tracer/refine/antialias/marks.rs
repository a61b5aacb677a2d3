//! Marks edges between neighbouring pixels: a bit per pixel of a stretch.

use crate::grid::each;
use crate::lanes::*;
use crate::picture::{Band, CELL, MAX_WIDTH, RoughRow, TILE_HEIGHT, TILE_WIDTH};
use crate::plan::FramePlan;
use crate::refine::worker::STRETCH;
use core::ops::Range;
use fearless_simd::{u8x16, u8x32, u32x4, u32x8};

/// Marks per row of pixels.
pub(super) const ROWS: usize = 2;

/// A row of the picture.
pub(super) type RowMarks = [u64; MAX_STRETCHES];

pub(super) const MAX_STRETCHES: usize = MAX_WIDTH.div_ceil(STRETCH);

const CELLS: usize = STRETCH / CELL;

/// Marks of a stretch. Each row has the edges to the row above, then the edges to the right; the
/// last entry has the edges to the row below the band.
pub(super) type EdgeMarks = [u64; ROWS * TILE_HEIGHT + 1];

pub(super) fn stretch(word: usize, width: usize) -> Range<usize> {
    width.min(word * STRETCH)..width.min((word + 1) * STRETCH)
}

pub(super) fn rough_cells(row: &RoughRow, word: usize) -> u64 {
    let tile = row[word / (TILE_WIDTH / STRETCH)];
    tile >> (CELLS * word % (TILE_WIDTH / CELL)) & ((1 << CELLS) - 1)
}

/// Marks edges between two lines of pixels, in the cells whose bits are set.
#[inline(never)]
pub(super) fn mark(plan: &FramePlan, line: &[u32], other: &[u32], cells: u64) -> u64 {
    let edge = plan.quality.edge;
    let mut marks = 0;
    each(cells, |cell| {
        let (start, end) = (CELL * cell, CELL * (cell + 1));
        marks |= match (line.get(start..end), other.get(start..end)) {
            (Some(a), Some(b)) => edges(edge, a, b) << start,
            _ => {
                let pairs = line.iter().zip(other).enumerate().skip(start);
                pairs.fold(0, |marks, (i, (&a, &b))| marks | u64::from(is_edge(edge, a, b)) << i)
            }
        };
    });
    marks
}

/// Marks the edges of a stretch, except to the right of the finished columns, where the method is
/// drawn.
pub(super) fn mark_stretch(
    plan: &FramePlan,
    band: &Band<'_>,
    word: usize,
    [above, below]: [&RowMarks; 2],
    marks: &mut EdgeMarks,
) {
    let finished = plan.finished;
    let stretch = stretch(word, finished);
    let right = finished.min(stretch.start + 1)..finished.min(stretch.end + 1);
    let rows = band.height();
    let line = |y: usize, part: &Range<usize>| &band.pixels[y * band.stride..][part.clone()];
    marks[0] = above[word];
    for y in 0..rows {
        let rough = &band.rough[y / CELL];
        let here = rough_cells(rough, word);
        // The last pixel of a cell is adjacent to the next cell.
        let next = if word + 1 < MAX_STRETCHES { rough_cells(rough, word + 1) & 1 } else { 0 };
        let adjacent = here | here >> 1 | next << (CELLS - 1);
        marks[ROWS * y + 1] = mark(plan, line(y, &stretch), line(y, &right), adjacent);
        marks[ROWS * y + 2] = if y + 1 < rows {
            let both = here | rough_cells(&band.rough[(y + 1) / CELL], word);
            mark(plan, line(y, &stretch), line(y + 1, &stretch), both)
        } else {
            below[word]
        };
    }
}

#[inline(always)]
fn edges(edge: u8, a: &[u32], b: &[u32]) -> u64 {
    let [a, b]: [u8x32<Baseline>; 2] =
        [a, b].map(|row| u32x8::from_slice(baseline(), row).bitcast());
    let over = (a.max(b) - a.min(b)).saturating_sub(edge - 1);
    let over: u32x8<Baseline> = over.bitcast();
    (!over.simd_eq(0)).to_bitmask()
}

#[inline(never)]
pub(in crate::refine) fn is_edge(edge: u8, a: u32, b: u32) -> bool {
    let [a, b]: [u8x16<Baseline>; 2] =
        [a, b].map(|pixel| u32x4::splat(baseline(), pixel).bitcast());
    let over = (a.max(b) - a.min(b)).saturating_sub(edge - 1);
    let over: u32x4<Baseline> = over.bitcast();
    over.as_slice()[0] != 0
}
