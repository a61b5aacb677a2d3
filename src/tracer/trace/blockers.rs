//! The solids that may be on a packet's way to a lamp: lists that are made anew for each lamp.

use super::candidates::Candidates;
use crate::scene::MAX_SOLIDS;

/// The solids that may be on a packet's way to a lamp.
pub(super) struct Blockers {
    /// Whose shadow cones the packet meets.
    pub(super) casters: Casters,
    /// Those of them that may hide some of the lamp, by an exact test.
    pub solids: Candidates,
}

impl Blockers {
    /// None.
    pub const NONE: Self = Self {
        casters: Casters {
            indices: [0; CAPACITY],
            len: 0,
        },
        solids: Candidates::NONE,
    };
}

/// At least the most solids, and a power of two, so that one instruction keeps an index below it.
const CAPACITY: usize = MAX_SOLIDS.next_power_of_two();

/// The indices of some shadow cones of a lamp, in their order.
pub(super) struct Casters {
    indices: [u16; CAPACITY],
    len: usize,
}

impl Casters {
    /// Removes all casters.
    #[inline(always)]
    pub fn clear(&mut self) {
        self.len = 0;
    }

    /// Adds a caster if it is met, without a branch: which casters a packet meets cannot be predicted.
    #[inline(always)]
    pub fn push_if(&mut self, index: usize, is_met: bool) {
        self.indices[self.len % CAPACITY] = index as u16;
        self.len += usize::from(is_met);
    }

    /// All indices.
    #[inline(always)]
    pub fn as_slice(&self) -> &[u16] {
        &self.indices[..self.len.min(CAPACITY)]
    }
}
