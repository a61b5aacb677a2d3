use super::guard::Guard;
use crate::counts::Counts;
use crate::grid::{Bits, LEVELS, Pyramid};
use crate::picture::TILE_HEIGHT;
use crate::trace::{BATCH, Batch};
use crate::zero::Zero;

/// The working memory of one thread. A single worker renders on the caller's thread: see
/// [`Threads`](crate::Threads).
pub struct Worker {
    pub(super) batch: Batch,
    pub(super) pyramid: Pyramid,
    pub(super) marks: Marks,
    pub(super) guard: Guard,
    pub(super) intervals: [Interval; BATCH],
    pub(super) found: usize,
}

zero! {
    Worker { batch, pyramid, marks, guard, intervals, found }
    Marks { squares, open, filled, traced }
    Interval { ends, start, half, word }
}

impl Worker {
    /// The size in bytes, at most 460,000, for any picture.
    pub const BYTES: usize = size_of::<Self>();

    /// Allocates workers in place on the heap, even in unoptimised programs.
    #[cfg(feature = "std")]
    #[must_use]
    pub fn several(count: usize) -> std::vec::Vec<Self> {
        let mut workers = std::vec::Vec::with_capacity(count);
        for _ in 0..count {
            // The macro writes a constant in place; `push` would copy it from the stack.
            workers.append(&mut std::vec![const { Self::new() }]);
        }
        workers
    }

    /// Returns zeroed memory.
    #[must_use]
    pub const fn new() -> Self {
        // As in `Memory::new`.
        const { Self::ZERO }
    }

    pub(crate) fn take_counts(&mut self) -> Counts {
        core::mem::take(&mut self.batch.counts)
    }
}

default!(Worker = Self::new());

const _: () = assert!(Worker::BYTES <= 460_000);

pub(super) const CLUSTER_WIDTH: usize = 4;
/// A cluster's points are a word's bits. (Clusters of 8x8 points make a show 6 % slower.)
pub(super) const CLUSTER_HEIGHT: usize = 64 / CLUSTER_WIDTH;

pub(super) struct Marks {
    /// The squares to judge: all of the top level, then the parts of split squares.
    pub squares: [[Bits; TILE_HEIGHT]; LEVELS],
    /// The squares that may show a feature between their corners; before the guard runs, parts of
    /// such squares.
    pub open: [[Bits; TILE_HEIGHT]; LEVELS],
    /// Filled squares. Single pixels are never filled, so half the rows suffice.
    pub filled: [[Bits; TILE_HEIGHT / 2]; LEVELS],
    /// The last cluster may extend beyond the rows.
    pub traced: [[Bits; TILE_HEIGHT + CLUSTER_HEIGHT]; LEVELS],
}

/// The pixels that share a word of marks and a set of visible groups.
pub(super) const STRETCH: usize = u64::BITS as usize;

/// A part of a pixel's half-axis that contains an edge.
#[derive(Clone, Copy)]
pub(super) struct Interval {
    pub ends: [u64; 2],
    /// The end nearer to the centre, as a point of the queue.
    pub start: u32,
    /// Half of its length along its axis, in parts of a pixel.
    pub half: i16,
    pub word: u16,
}

impl Interval {
    pub fn middle(&self) -> u32 {
        let step = i32::from(self.half) << (16 * (self.word % 2));
        self.start.wrapping_add_signed(step)
    }
}
