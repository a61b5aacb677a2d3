//! A point's key: what its ray tree met.
//!
//! A node of the tree gives a number that depends on its place in the tree, its object and its lights' states; the key
//! is the sum of those numbers. Equal trees have equal keys. Different trees have equal keys with a chance of 2^-32: a
//! sum of hashes, not a proof, but a frame compares some 10^5 keys, so one frame in 40,000 fills one square wrongly.

use crate::lanes::*;
use crate::quality::Quality;

/// Bits of a node's number that hold the place in the tree.
const PATH_BITS: u32 = 8;
/// Bits that hold the object.
const OBJECT_BITS: u32 = 12;
/// Bits that hold one light's state.
const STATE_BITS: u32 = 2;

/// The lights' states at a hit: 0 dark (shadowed or facing away), 1 lit, 2 lit with a highlight.
#[derive(Clone, Copy)]
pub(crate) struct States<S: Isa>(U<S>);

impl<S: Isa> States<S> {
    #[inline(always)]
    pub fn new(simd: S) -> Self {
        Self(U::<S>::splat(simd, 0))
    }

    /// Adds one light's state. A highlight implies lit.
    #[inline(always)]
    pub fn push(&mut self, lit: M<S>, highlight: M<S>) {
        let simd = self.0.token();
        let one = U::<S>::splat(simd, 1);
        let zero = U::<S>::splat(simd, 0);
        let state = lit.select(one, zero) + highlight.select(one, zero);
        self.0 = (self.0 << STATE_BITS) | state;
    }
}

/// The nodes' terms of the keys; 0 where nothing is compared.
#[inline(always)]
pub(crate) fn term<S: Isa>(
    simd: S,
    quality: &Quality,
    active: M<S>,
    paths: U<S>,
    objects: U<S>,
    states: States<S>,
) -> U<S> {
    if !quality.needs_keys() {
        return U::<S>::splat(simd, 0);
    }
    let zero = U::<S>::splat(simd, 0);
    let to_depth =
        |depth: u32| paths.simd_lt(U::<S>::splat(simd, 2 << depth.min(Quality::MAX_DEPTH)));
    let with_states = to_depth(quality.state_depth);
    let counted = active & to_depth(quality.key_depth);
    let states = with_states.select(states.0, zero) << (PATH_BITS + OBJECT_BITS);
    let mut h = paths | (objects << PATH_BITS) | states;
    // Two rounds of multiply and shift (after Wellons' searched 32-bit mixers) spread every bit.
    h ^= h >> 16;
    h *= U::<S>::splat(simd, 0x7feb_352d);
    h ^= h >> 15;
    h *= U::<S>::splat(simd, 0x846c_a68b);
    counted.select(h ^ (h >> 16), zero)
}
