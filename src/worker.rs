//! A thread's working memory.

use crate::lanes::LANES;
use crate::refine::{Points, Square, band::MAX_SPLITS};
use crate::trace::{Batch, Counts, PACKETS};

/// What one thread works in: some MB of fixed size, owned by the caller, reused from band to band.
pub struct Worker {
    pub(crate) batch: Batch,
    pub(crate) points: Points,
    /// Pixels of a batch.
    pub(crate) pixels: [[u32; LANES]; PACKETS],
    /// Squares to split, of this round and of the next.
    pub(crate) splits: [[Square; MAX_SPLITS]; 2],
}

impl Worker {
    /// Empty working memory.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            batch: Batch::new(),
            pixels: [[0; LANES]; PACKETS],
            points: Points::new(),
            splits: [[Square {
                x: 0,
                y: 0,
                w: 0,
                h: 0,
            }; MAX_SPLITS]; 2],
        }
    }

    pub(crate) fn take_counts(&mut self) -> Counts {
        core::mem::take(&mut self.batch.counts)
    }
}

impl Default for Worker {
    fn default() -> Self {
        Self::new()
    }
}
