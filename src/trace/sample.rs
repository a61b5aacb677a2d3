//! What is kept of a traced point.

/// A traced point's colour: red, green and blue from the low bits up, 16 bits each, in 256ths of an output step.
#[derive(Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Sample(pub u64);

/// Parts that a sample counts an output step in.
pub(crate) const STEP: i32 = 256;

/// The brightest channel of a sample: 255 steps.
const WHITE: i32 = 255 * STEP;

/// Bits that the fixed point of a sum has below those of a sample.
const SPARE_BITS: i32 = super::batch::STEP_BITS - STEP.trailing_zeros() as i32;

impl Sample {
    /// The colour of a sum, cut to 0 to 255 steps.
    #[inline(always)]
    pub fn from_sum(sum: &[i32; 4]) -> Self {
        // Cut off, not rounded: so a pixel is the sum rounded once.
        let channel = |i: usize| (sum[i] >> SPARE_BITS).clamp(0, WHITE) as u64;
        Self(channel(0) | channel(1) << 16 | channel(2) << 32)
    }

    /// Channel `i`, 0 to 2, in steps.
    #[inline(always)]
    pub fn channel(self, i: usize) -> f32 {
        (self.0 >> (16 * i)) as u16 as f32 * (1.0 / STEP as f32)
    }

    /// The colour as a pixel, `0x00RRGGBB`, rounded.
    #[inline(always)]
    pub fn pixel(self) -> u32 {
        // Half a step is added to each channel; none of them overflows.
        let half = self.0 + 0x0080_0080_0080;
        let byte = |i: usize| (half >> (16 * i + 8)) as u32 & 255;
        byte(0) << 16 | byte(1) << 8 | byte(2)
    }
}
