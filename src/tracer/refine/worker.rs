//! A thread's working memory.

use crate::counts::Counts;
use crate::coverage::Guard;
use crate::grid::{Bits, LEVELS, Pyramid};
use crate::picture::TILE_HEIGHT;
use crate::trace::{BATCH, Batch};

/// The memory that one thread works in, of fixed size: [`Worker::BYTES`].
///
/// Alone, it renders on the caller's thread: see [`Threads`](crate::Threads).
pub struct Worker {
    pub(super) batch: Batch,
    pub(super) pyramid: Pyramid,
    pub(super) marks: Marks,
    pub(super) guard: Guard,
    /// Where the batch's points go: in the pyramid, or pixels in the band.
    pub(super) targets: [u32; BATCH],
    /// The intervals in which edges lie, and how many there are.
    pub(super) intervals: [Interval; BATCH],
    pub(super) found: usize,
}

impl Worker {
    /// Its size in bytes, at most 460,000: the same for pictures of any size.
    pub const BYTES: usize = size_of::<Self>();

    /// Allocates workers. No part of them is ever on the stack, not even in unoptimised programs.
    #[cfg(feature = "std")]
    #[must_use]
    pub fn several(count: usize) -> std::vec::Vec<Self> {
        let mut workers = std::vec::Vec::with_capacity(count);
        for _ in 0..count {
            // This macro writes a constant in place; `push` would copy it from the stack.
            workers.append(&mut std::vec![const { Self::new() }]);
        }
        workers
    }

    /// Returns empty working memory.
    #[must_use]
    pub const fn new() -> Self {
        // Put together by the compiler: unoptimised code would make each part on the stack first.
        const {
            Self {
                batch: Batch::new(),
                pyramid: Pyramid::new(),
                marks: Marks::new(),
                guard: Guard::new(),
                targets: [0; BATCH],
                intervals: [Interval::NONE; _],
                found: 0,
            }
        }
    }

    /// Takes the counts since this was last asked.
    pub(crate) fn take_counts(&mut self) -> Counts {
        core::mem::take(&mut self.batch.counts)
    }
}

impl Default for Worker {
    fn default() -> Self {
        Self::new()
    }
}

const _: () = assert!(Worker::BYTES <= 460_000);

/// Points are traced cluster by cluster: rays of neighbours meet the same objects. A cluster is as many points wide.
pub(super) const CLUSTER_WIDTH: usize = 4;
/// Rows of a cluster: its points are the bits of a word. (Clusters of 8x8 points take the show 6 % longer.)
pub(super) const CLUSTER_HEIGHT: usize = 64 / CLUSTER_WIDTH;

/// The squares and points of a tile that matter, a row of bits for each row of a level's.
pub(super) struct Marks {
    /// Squares that are looked at: all of the largest, then the parts of those that were split.
    pub squares: [[Bits; TILE_HEIGHT]; LEVELS],
    /// Those of them that may show something which their corners do not; before the guard has looked at them, the parts of
    /// such ones.
    pub open: [[Bits; TILE_HEIGHT]; LEVELS],
    /// Those that were filled: no pixels, so there are half as many rows at most.
    pub filled: [[Bits; TILE_HEIGHT / 2]; LEVELS],
    /// Points that were traced; clusters of them end with more rows than there are.
    pub traced: [[Bits; TILE_HEIGHT + CLUSTER_HEIGHT]; LEVELS],
}

impl Marks {
    pub const fn new() -> Self {
        Self {
            squares: [[Bits::NONE; TILE_HEIGHT]; LEVELS],
            open: [[Bits::NONE; TILE_HEIGHT]; LEVELS],
            filled: [[Bits::NONE; TILE_HEIGHT / 2]; LEVELS],
            traced: [[Bits::NONE; TILE_HEIGHT + CLUSTER_HEIGHT]; LEVELS],
        }
    }
}

/// Pixels of a stretch of a band along x, whose rays meet the same groups: as many as a word has marks.
pub(super) const STRETCH: usize = u64::BITS as usize;

/// A part of the way from a pixel's centre to its border in which an edge lies.
#[derive(Clone, Copy)]
pub(super) struct Interval {
    /// The colours at both ends.
    pub ends: [u64; 2],
    /// The end that is nearer to the centre, as the queue has it.
    pub start: u32,
    /// Half of its length, in parts of a pixel along its axis.
    pub half: i16,
    /// The word of the pixel's changes along this axis.
    pub word: u16,
}

impl Interval {
    const NONE: Self = Self {
        ends: [0; 2],
        start: 0,
        half: 0,
        word: 0,
    };

    /// The place in its middle.
    pub fn middle(&self) -> u32 {
        let way = i32::from(self.half) << (16 * (self.word % 2));
        self.start.wrapping_add_signed(way)
    }
}
