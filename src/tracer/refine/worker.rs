//! A thread's working memory.

use super::guard::CoverageGuard;
use super::marks::Marks;
use super::middles::{Middles, NO_MIDDLES};
use super::pyramid::Pyramid;
use crate::counts::Counts;
use crate::trace::{BATCH, Batch};

/// The memory that one thread works in, of fixed size, and reused from tile to tile: at most 460,000 bytes, see [`Worker::BYTES`].
///
/// Alone, it renders on the caller's thread: see [`Threads`](crate::Threads).
pub struct Worker {
    pub(super) batch: Batch,
    pub(super) pyramid: Pyramid,
    pub(super) marks: Marks,
    pub(super) guard: CoverageGuard,
    /// Where the batch's points go: in the pyramid, or pixels in the band.
    pub(super) targets: [u32; BATCH],
    /// The points beside the pixels of a stretch that is antialiased.
    pub(super) middles: Middles,
}

impl Worker {
    /// How large a worker is, in bytes: the same for pictures of any size.
    pub const BYTES: usize = size_of::<Self>();

    /// Empty working memory.
    #[must_use]
    pub const fn new() -> Self {
        // Put together by the compiler: unoptimised code would make each part on the stack first.
        const {
            Self {
                batch: Batch::new(),
                pyramid: Pyramid::new(),
                marks: Marks::new(),
                guard: CoverageGuard::new(),
                targets: [0; BATCH],
                middles: NO_MIDDLES,
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
