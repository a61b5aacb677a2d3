//! Chance that repeats.

/// Numbers that look random: Steele, Lea and Flood's SplitMix with the 32-bit mixer of Wellons and Mulvey.
pub(super) struct Random(pub u32);

impl Random {
    /// The next one, 0 to below 1.
    pub fn share(&mut self) -> f32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9);
        let mut h = self.0;
        h = (h ^ (h >> 16)).wrapping_mul(0x7feb_352d);
        h = (h ^ (h >> 15)).wrapping_mul(0x846c_a68b);
        h ^= h >> 16;
        (h >> 8) as f32 / (1 << 24) as f32
    }
}
