//! Keys: hashes of the objects that a point's ray tree hit.
//!
//! A key is the sum over the tree's nodes of a hash of the position in the tree, the object and the
//! lights' states, or, below `state_depth`, the hash of the object's pattern. Different trees
//! collide with a probability of 2^-32: one frame in 40,000 fills a square wrongly.

use super::rays::{PATH_BITS, Rays};
use crate::lanes::*;
use crate::quality::Quality;

const OBJECT_BITS: u32 = 12;
const STATE_BITS: u32 = 2;

/// The nodes of a packet, and the lights' states there: 0 dark (in shadow or facing away), 1 lit, 2
/// lit with a highlight.
#[derive(Clone, Copy)]
pub(crate) struct Keys<S: Isa> {
    paths: U<S>,
    counted: M<S>,
    /// Whether any node counts; in most packets of secondary rays none does.
    has_any: bool,
    states: U<S>,
}

impl<S: Isa> Keys<S> {
    #[inline(always)]
    pub fn new(simd: S, quality: &Quality, active: M<S>, rays: &Rays<S>) -> Self {
        let paths = rays.paths();
        let mut keys = Self {
            paths,
            counted: active,
            has_any: quality.needs_keys(),
            states: U::<S>::splat(simd, 0),
        };
        if keys.has_any {
            keys.counted &= to_depth(simd, paths, quality.key_depth)
                & rays.weight.simd_ge(splat(simd, quality.key_weight));
            keys.has_any = keys.counted.any_true();
        }
        keys
    }

    #[inline(always)]
    pub fn push(&mut self, lit: M<S>, highlight: M<S>) {
        if !self.has_any {
            return;
        }
        let simd = self.states.token();
        let one = U::<S>::splat(simd, 1);
        let zero = U::<S>::splat(simd, 0);
        let state = lit.select(one, zero) + highlight.select(one, zero);
        self.states = (self.states << STATE_BITS) | state;
    }

    #[inline(always)]
    pub fn terms(&self, simd: S, quality: &Quality, objects: U<S>, pattern_hash: U<S>) -> U<S> {
        let zero = U::<S>::splat(simd, 0);
        if !self.has_any {
            return zero;
        }
        let with_states = to_depth(simd, self.paths, quality.state_depth);
        let states = with_states.select(self.states, pattern_hash) << (PATH_BITS + OBJECT_BITS);
        let mut h = self.paths | (objects << PATH_BITS) | states;
        // Two rounds of multiply and shift (after Wellons' searched 32-bit mixers) spread every
        // bit.
        h ^= h >> 16;
        h *= U::<S>::splat(simd, 0x7feb_352d);
        h ^= h >> 15;
        h *= U::<S>::splat(simd, 0x846c_a68b);
        self.counted.select(h ^ (h >> 16), zero)
    }
}

#[inline(always)]
fn to_depth<S: Isa>(simd: S, paths: U<S>, depth: u32) -> M<S> {
    paths.simd_lt(U::<S>::splat(simd, 2 << depth.min(Quality::MAX_DEPTH)))
}
