//! The solids that need an exact test, one by one, after the tree has been traversed.

use crate::lanes::*;
use crate::prepare::ObjectId;
use crate::scene::{List, MAX_SOLIDS};

/// A solid that some rays of a packet may hit.
///
/// For the other rays the result of the exact test is ignored, so that a ray's hit does not depend on the other rays of its
/// packet.
#[derive(Clone, Copy, Default)]
pub(crate) struct Candidate {
    pub object: ObjectId,
    /// One bit for each lane whose ray may hit it.
    lanes: u16,
}

/// The candidates of a packet. Each solid is one node of the tree, so it is in the list at most once.
pub(crate) type Candidates = List<Candidate, MAX_SOLIDS>;

impl Candidate {
    /// All zeros.
    const ZERO: Self = Self {
        object: ObjectId::FIRST,
        lanes: 0,
    };

    /// Returns a solid for some lanes.
    #[inline(always)]
    pub fn new<S: Isa>(object: ObjectId, lanes: M<S>) -> Self {
        let lanes = lanes.to_bitmask() as u16;
        Self { object, lanes }
    }

    /// Returns the lanes whose rays may hit it.
    #[inline(always)]
    pub fn lanes<S: Isa>(self, simd: S) -> M<S> {
        M::<S>::from_bitmask(simd, u64::from(self.lanes))
    }
}

/// The solids that may be on a packet's way to a light.
pub(super) struct Occluders {
    /// The indices of the shadow cones that the packet meets, in the light's list.
    pub(super) cones: [u16; CONES],
    /// The solids among them that may hide some of the light, by an exact test.
    pub solids: Candidates,
}

/// At least the most solids, and a power of two, so that one instruction keeps an index below it.
pub(super) const CONES: usize = MAX_SOLIDS.next_power_of_two();

impl Occluders {
    /// No occluders.
    pub const NONE: Self = Self {
        cones: [0; CONES],
        solids: NONE,
    };
}

/// No candidates.
pub(crate) const NONE: Candidates = List::over(Candidate::ZERO);
