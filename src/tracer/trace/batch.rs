//! A batch of points, and the parameters of its rays.

use super::accumulator::Accumulator;
use super::candidates::{Candidates, Occluders};
use super::queue::Queue;
use super::stack::RayStack;
use super::surface::SurfaceRows;
use crate::counts::Counts;
use crate::prepare::{Film, World};
use crate::quality::Quality;

pub(crate) struct Batch {
    pub points: Queue,
    pub results: Accumulator,
    pub counts: Counts,
    pub(super) stack: RayStack,
    pub(super) blocks: Candidates,
    pub(super) occluders: Occluders,
    pub(super) surfaces: SurfaceRows,
}

zero! { Counts = Self::NONE; }

zero! { Batch { points, results, counts, stack, blocks, occluders, surfaces } }

impl Batch {
    #[inline(never)]
    pub fn begin(&mut self) {
        self.surfaces.clear();
    }

    /// A thousandth of the time: the baseline suffices.
    #[inline(never)]
    pub(super) fn finish(&mut self, film: &Film) {
        self.results.finish(film, &self.points);
    }
}

#[derive(Clone, Copy)]
pub(crate) struct Tracer<'a, S> {
    pub isa: S,
    pub world: World<'a>,
    pub quality: &'a Quality,
}
