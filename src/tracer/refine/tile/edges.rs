//! Opens filled squares at which an edge ends: a feature crosses them between their corners.
//!
//! Each pair of pixels across the border of a smooth and a rough cell has a bit, set if they differ
//! by an edge. The first pair is at a traced corner. If its bit is clear and another is set, the
//! rough cell's edge does not continue in the smooth cell.

use super::state::Tile;
use crate::grid::{Bits, each};
use crate::observe::Observer;
use crate::picture::{CELL, TILE_WIDTH};
use crate::refine::antialias::is_edge;

impl<O: Observer> Tile<'_, '_, O> {
    /// Traces all pixels of smooth cells at whose sides a rough cell's edge ends, until there is no
    /// such cell.
    pub(super) fn follow_edges(&mut self) {
        let [columns, rows] = [self.area.columns(0), self.area.rows(0)].map(|size| size / CELL);
        let whole = Bits::below(columns).0[0];
        let (stride, edge) = (self.band.stride, self.context.plan.quality.edge);
        // Fainter edges are not worth a cell's points.
        let edge = edge.saturating_add(edge / 2);
        loop {
            for y in 0..rows {
                for side in 0..(rows - y).min(2) {
                    let own = self.rough(y);
                    let (other, among, along, across) = if side == 0 {
                        (own >> 1, whole >> 1, stride, 1)
                    } else {
                        (self.rough(y + 1), whole, 1, stride)
                    };
                    let drawn = self.drawn(y)
                        & if side == 0 { self.drawn(y) >> 1 } else { self.drawn(y + 1) };
                    each((own ^ other) & among & drawn, |x| {
                        let mut at = self.area.left + CELL * (y * stride + x) + (CELL - 1) * across;
                        // A one above the pairs' bits ends the loop: smaller code than a range.
                        let mut edges = 1_u32;
                        while edges >> CELL == 0 {
                            // The pixel between them may be a mean of corners.
                            let [a, b] = [at, at + 2 * across].map(|at| self.band.pixels[at]);
                            edges = edges << 1 | u32::from(is_edge(edge, a, b));
                            at += along;
                        }
                        if (0b1_0000_0001..0b1_1000_0000).contains(&edges) {
                            self.open(x, y);
                            self.open(x + 1 - side, y + side);
                        }
                    });
                }
            }
            if self.worker.batch.points.len() == 0 {
                break;
            }
            self.trace(0);
        }
    }

    /// Returns the cells that are drawn, not copied by a fold.
    fn drawn(&self, y: usize) -> u64 {
        self.worker.marks.squares[CELL.ilog2() as usize][y].0[0]
    }

    fn rough(&self, y: usize) -> u64 {
        self.band.rough[y][self.area.left / TILE_WIDTH]
    }

    #[inline(never)]
    fn open(&mut self, x: usize, y: usize) {
        if self.rough(y) >> (x % 64) & 1 == 0 {
            self.band.rough[y][self.area.left / TILE_WIDTH] |= 1 << (x % 64);
            // For the overlay. A word of 64 pixels has a byte for each cell.
            for row in &mut self.worker.marks.traced[0][CELL * y..][..CELL] {
                row.0[x / CELL] |= 0xff << (x % CELL * CELL);
            }
            for left in [CELL * x, CELL * x + CELL / 2] {
                self.add_cluster(0, [left, CELL * y], 0xffff_ffff);
            }
        }
    }
}
