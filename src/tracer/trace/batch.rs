//! A batch: what a thread needs to trace some points together.

use super::WideKernel;
use super::accumulator::Accumulator;
use super::candidates::Candidates;
use super::casters::Casters;
use super::counts::Counts;
use super::queue::Queue;
use super::stack::RayStack;
use super::surface::SurfaceRows;

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
    /// Solids that may be on the way of the packet at work to a lamp.
    pub(super) casters: Casters,
    /// Objects that the packet at work may meet beyond spheres and planes, or on its way to a lamp, by an exact test.
    pub(super) candidates: Candidates,
    /// The surfaces of the packet at work.
    pub(super) surfaces: SurfaceRows,
    /// The kernel for wide packets, if there is one.
    pub wide: Option<WideKernel>,
}

impl Batch {
    /// Room for points, empty.
    pub const fn new() -> Self {
        Self {
            points: Queue::new(),
            results: Accumulator::new(),
            counts: Counts::NONE,
            stack: RayStack::new(),
            candidates: Candidates::NONE,
            casters: Casters::NONE,
            surfaces: SurfaceRows::NONE,
            wide: None,
        }
    }

    /// Begins a part of a picture: forgets the surfaces of other frames. Points are counted in so many parts of a pixel.
    #[inline(never)]
    pub fn begin(&mut self, parts: usize) {
        self.surfaces.clear();
        self.points.count_in_parts(parts);
    }
}
