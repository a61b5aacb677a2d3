use crate::lanes::*;
use crate::prepare::ObjectId;
use crate::scene::{List, MAX_SOLIDS};

/// A solid that needs an exact test in some lanes after the traversal. Other lanes ignore it: a hit
/// must not depend on its packet.
#[derive(Clone, Copy, Default)]
pub(crate) struct Candidate {
    pub object: ObjectId,
    lanes: u16,
}

/// Each solid at most once.
pub(crate) type Candidates = List<Candidate, MAX_SOLIDS>;

impl Candidate {
    #[inline(always)]
    pub fn new<S: Isa>(object: ObjectId, lanes: M<S>) -> Self {
        let lanes = lanes.to_bitmask() as u16;
        Self { object, lanes }
    }

    #[inline(always)]
    pub fn lanes<S: Isa>(self, simd: S) -> M<S> {
        M::<S>::from_bitmask(simd, u64::from(self.lanes))
    }
}

/// The solids that may be between a packet's points and a light.
pub(super) struct Occluders {
    /// The indices of the shadow cones that the packet meets.
    pub(super) cones: [u16; CONES],
    pub solids: Candidates,
}

/// A power of two: one instruction bounds an index.
pub(super) const CONES: usize = MAX_SOLIDS.next_power_of_two();

zero! {
    Candidate { object, lanes }
    Occluders { cones, solids }
}
