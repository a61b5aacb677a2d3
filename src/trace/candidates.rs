//! Boxes, cylinders and whatever else a packet's rays may meet, to be looked at one by one.

use crate::lanes::*;
use crate::prepare::ObjectId;
use crate::scene::MAX_SOLIDS;

/// A solid that some rays of a packet may meet.
///
/// The other rays do not meet it, whatever the exact test finds for them: what a ray meets does not depend on the rays that
/// it travels with.
#[derive(Clone, Copy)]
pub(crate) struct Candidate {
    pub object: ObjectId,
    /// A bit for each lane whose ray may meet it.
    lanes: u16,
}

impl Candidate {
    /// The lanes whose rays may meet it.
    #[inline(always)]
    pub fn lanes<S: Isa>(self, simd: S) -> M<S> {
        M::<S>::from_bitmask(simd, u64::from(self.lanes))
    }
}

/// The solids that the rays of a packet may meet. A solid is one node of the tree, so it is here at most once.
pub(crate) struct Candidates {
    list: [Candidate; MAX_SOLIDS],
    len: usize,
}

impl Candidates {
    /// None, all zeros.
    pub const NONE: Self = Self {
        list: [Candidate {
            object: ObjectId::FIRST,
            lanes: 0,
        }; MAX_SOLIDS],
        len: 0,
    };

    /// Leaves none.
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

    /// Whether there are none.
    #[inline(always)]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// All of them.
    #[inline(always)]
    pub fn as_slice(&self) -> &[Candidate] {
        &self.list[..self.len]
    }
}
