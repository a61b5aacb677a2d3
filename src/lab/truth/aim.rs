//! Where photons are sent: from a lamp to a body, by those directions from which light comes to rough surfaces.
//!
//! Of all that a lamp sends towards a body, what comes on by a second one may be a thousandth: then a sample has no photon of it at all,
//! or a single one, as bright as a thousand. So directions are looked through once for each picture, from coarse to fine, and most
//! photons are sent by those that were found. The others stay possible, such that nothing is left out.

use crate::sampler::Sampler;
use eightfold_tracer::glam::{DVec2, dvec2};

/// The parts, both ways, that directions are divided into at first.
const COARSEST: usize = 64;
/// The most such parts.
const FINEST: usize = 1024;
/// Parts are divided while there are fewer.
const ENOUGH: usize = 1024;
/// The share of photons that are sent by the parts that were found; the others by any.
const AIMED: f64 = 0.75;

/// The parts of a square of directions by which light arrives.
#[derive(Clone, Debug)]
pub struct Aim {
    /// How many parts there are, both ways.
    side: usize,
    /// Those by which light arrives, sorted.
    cells: Vec<usize>,
}

/// How far a photon comes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Reach {
    /// Nowhere from the body that it is sent to.
    Nowhere,
    /// To another body that mirrors it or lets it through.
    Further,
    /// To a rough surface, where it is left.
    Rough,
}

impl Aim {
    /// Looks through a square of directions. `tried` tells how far photons come by some directions of a part, which is given by its
    /// lower corner and its side.
    pub fn new(tried: impl Fn(DVec2, f64) -> Reach) -> Self {
        let mut all = Self {
            side: COARSEST,
            cells: (0..COARSEST * COARSEST).collect(),
        };
        loop {
            let cells = all.cells.iter();
            let side = 1.0 / all.side as f64;
            let found: Vec<(usize, Reach)> = cells
                .map(|&cell| (cell, tried(all.corner(cell), side)))
                .collect();
            let lit = all.around(&found, Reach::Rough);
            let further = all.around(&found, Reach::Further);
            // What comes to a second body is looked through more finely for what that sends to rough surfaces.
            let next = if further.len() < ENOUGH {
                further
            } else {
                lit.clone()
            };
            all.cells = lit;
            if next.is_empty() || all.cells.len() >= ENOUGH || all.side == FINEST {
                return all;
            }
            all = all.divided(&next);
        }
    }

    /// The lower corner of a part.
    fn corner(&self, cell: usize) -> DVec2 {
        dvec2((cell % self.side) as f64, (cell / self.side) as f64) / self.side as f64
    }

    /// The parts by which photons come as far as that, and their neighbours, by which some may that have not been tried.
    fn around(&self, found: &[(usize, Reach)], least: Reach) -> Vec<usize> {
        let side = self.side;
        let near = |at: usize| at.saturating_sub(1)..(at + 2).min(side);
        let cells = found.iter().filter(|(_, reach)| *reach >= least);
        let mut all: Vec<usize> = cells
            .flat_map(|(cell, _)| {
                near(cell / side).flat_map(move |y| near(cell % side).map(move |x| y * side + x))
            })
            .collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// Some of its parts, each divided into four.
    fn divided(&self, cells: &[usize]) -> Self {
        let side = 2 * self.side;
        let quarters = |&cell: &usize| {
            let first = 2 * (cell / self.side * side + cell % self.side);
            [first, first + 1, first + side, first + side + 1]
        };
        Self {
            side,
            cells: cells.iter().flat_map(quarters).collect(),
        }
    }

    /// Chooses a direction, and tells its weight: how much less often it is chosen than all are in the mean.
    pub fn choose(&self, sampler: &mut Sampler) -> (DVec2, f64) {
        let (pick, u) = (sampler.next_1d(), sampler.next_2d());
        if self.cells.is_empty() {
            return (u, 1.0);
        }
        let chosen = (pick / AIMED * self.cells.len() as f64) as usize;
        let u = self
            .cells
            .get(chosen)
            .map_or(u, |&cell| self.corner(cell) + u / self.side as f64);
        let [x, y] = [u.x, u.y].map(|at| (at * self.side as f64) as usize);
        let is_found = self.cells.binary_search(&(y * self.side + x)).is_ok();
        let found = (self.side * self.side) as f64 / self.cells.len() as f64;
        let density = (1.0 - AIMED) + if is_found { AIMED * found } else { 0.0 };
        (u, 1.0 / density)
    }
}
