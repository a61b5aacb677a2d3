//! The solids that need an exact test, one by one, after the tree has been traversed.

use crate::lanes::*;
use crate::prepare::ObjectId;
use crate::scene::MAX_SOLIDS;

/// A solid that some rays of a packet may hit.
///
/// For the other rays the result of the exact test is ignored, so that a ray's hit does not depend on the other rays of its
/// packet.
#[derive(Clone, Copy)]
pub(crate) struct Candidate {
    pub object: ObjectId,
    /// One bit for each lane whose ray may hit it.
    lanes: u16,
}

impl Candidate {
    /// The lanes whose rays may hit it.
    #[inline(always)]
    pub fn lanes<S: Isa>(self, simd: S) -> M<S> {
        M::<S>::from_bitmask(simd, u64::from(self.lanes))
    }
}

/// The candidates of a packet. Each solid is one node of the tree, so it is in the list at most once.
pub(crate) struct Candidates {
    list: [Candidate; MAX_SOLIDS],
    len: usize,
}

impl Candidates {
    /// No candidates, all zeros.
    pub const NONE: Self = Self {
        list: [Candidate {
            object: ObjectId::FIRST,
            lanes: 0,
        }; MAX_SOLIDS],
        len: 0,
    };

    /// Removes all candidates.
    #[inline(always)]
    pub fn clear(&mut self) {
        self.len = 0;
    }

    /// Adds a solid for some lanes.
    #[inline(always)]
    pub fn push<S: Isa>(&mut self, object: ObjectId, lanes: M<S>) {
        self.list[self.len] = Candidate {
            object,
            lanes: lanes.to_bitmask() as u16,
        };
        self.len += 1;
    }

    /// Whether the list is empty.
    #[inline(always)]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// All candidates.
    #[inline(always)]
    pub fn as_slice(&self) -> &[Candidate] {
        &self.list[..self.len]
    }
}
