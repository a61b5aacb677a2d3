//! Pseudorandom numbers.

use eightfold_tracer::glam::{DVec2, dvec2};

/// A sequence of independent numbers.
#[derive(Clone, Debug)]
pub struct Random {
    key: u64,
    count: u64,
}

impl Random {
    /// Sequence number `index` of a seed.
    pub fn new(seed: u32, index: u32) -> Self {
        Self {
            key: mixed(u64::from(seed) << 32 | u64::from(index)),
            count: 0,
        }
    }

    /// Returns the next number, from 0 to below 1.
    pub fn next_1d(&mut self) -> f64 {
        let bits = mixed(self.key ^ self.count);
        self.count += 1;
        // The upper 53 bits fill the fraction of an f64.
        (bits >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Returns the next two numbers.
    pub fn next_2d(&mut self) -> DVec2 {
        dvec2(self.next_1d(), self.next_1d())
    }
}

/// The seed of part number `part`. Seeds of different parts look independent.
pub fn seed_of(seed: u32, part: u64) -> u32 {
    (mixed(mixed(u64::from(seed)) ^ part) >> 32) as u32
}

/// The first number of [`split_mix`] for a state: a bijection whose every output bit depends on all input bits.
fn mixed(mut bits: u64) -> u64 {
    split_mix(&mut bits)
}

/// The next pseudorandom number of a state (Steele, Lea and Flood's SplitMix64, 2014).
pub fn split_mix(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let bits = (*state ^ (*state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}
