//! A batch: what a thread needs to trace some points together.

use super::accumulator::Accumulator;
use super::candidates::{self, Blockers, Candidates};
use super::queue::Queue;
use super::stack::RayStack;
use super::surface::SurfaceRows;
use crate::counts::Counts;
use crate::prepare::Film;

/// Points to trace and what came of them. It is filled, traced, read and cleared again and again.
pub(crate) struct Batch {
    /// The points to trace.
    pub points: Queue,
    /// The results of the points.
    pub results: Accumulator,
    /// The work since this was last reset.
    pub counts: Counts,
    /// The secondary rays that wait to be traced.
    pub(super) stack: RayStack,
    /// Boxes and cylinders that the packet at work may meet, by an exact test.
    pub(super) blocks: Candidates,
    /// The solids that may be on the way of the packet at work to a lamp.
    pub(super) blockers: Blockers,
    /// The surfaces of the packet at work.
    pub(super) surfaces: SurfaceRows,
}

impl Batch {
    /// Room for points, empty.
    pub const fn new() -> Self {
        Self {
            points: Queue::new(),
            results: Accumulator::new(),
            counts: Counts::NONE,
            stack: RayStack::new(),
            blocks: candidates::NONE,
            blockers: Blockers::NONE,
            surfaces: SurfaceRows::NONE,
        }
    }

    /// Begins a part of a picture: forgets the surfaces of other frames.
    #[inline(never)]
    pub fn begin(&mut self) {
        self.surfaces.clear();
    }

    /// Turns the sums of the points into samples. This takes a thousandth of the time, so one instruction set is enough.
    #[inline(never)]
    pub(super) fn finish(&mut self, film: &Film) {
        self.results.finish(film, &self.points);
    }
}
