//! Pseudorandom numbers that repeat for each seed.

/// A generator with its state: SplitMix of Steele, Lea and Flood with the 32-bit mixer of Wellons and Mulvey.
pub(super) struct Random(pub u32);

impl Random {
    /// The next number, from 0 to below 1, uniformly distributed.
    pub fn fraction(&mut self) -> f32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9);
        let mut h = self.0;
        h = (h ^ (h >> 16)).wrapping_mul(0x7feb_352d);
        h = (h ^ (h >> 15)).wrapping_mul(0x846c_a68b);
        h ^= h >> 16;
        (h >> 8) as f32 / (1 << 24) as f32
    }
}
