//! A thread's working memory.

use crate::refine::{Points, Square, Unseen, refiner::MAX_SQUARES};
use crate::trace::{Batch, Counts};

/// What one thread works in: some MB of fixed size, owned by the caller, reused from band to band.
pub struct Worker {
    pub(crate) batch: Batch,
    pub(crate) points: Points,
    pub(crate) unseen: Unseen,
    /// Squares to look at, of this round and of the next.
    pub(crate) squares: [Square; MAX_SQUARES],
}

impl Worker {
    /// Empty working memory.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            batch: Batch::new(),
            points: Points::new(),
            unseen: Unseen::new(),
            squares: [Square {
                x: 0,
                y: 0,
                w: 0,
                h: 0,
                is_clear: false,
            }; MAX_SQUARES],
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
