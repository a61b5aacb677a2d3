use crate::lanes::*;
use crate::prepare::ObjectId;
use fearless_simd::{i16x8, i32x4, u32x4, u64x2};

/// The fractional bits of a sum of output steps: half a step is exact, and a ray tree's rounding
/// errors add up to less than 1/100 of a step.
pub(super) const STEP_BITS: i32 = 14;

pub(super) const FIXED_POINT: f32 = (255 << STEP_BITS) as f32;

/// Blue, green, red, and the key.
pub(super) type Sum = [i32; 4];

/// A traced point. From the low bits up: blue, green and red with 16 bits each, in 128ths of an
/// output step; the object's number plus one with 14 bits, 0 if unknown; bit 62, set if the
/// object's pattern is finer than squares; bit 63, set if the point shows
/// [unguarded](Sample::UNGUARDED) light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Sample(pub u64);

const SAMPLE_BITS: i32 = 7;

pub(crate) const STEP: i32 = 1 << SAMPLE_BITS;

const OBJECT: u32 = 48;

impl Sample {
    pub const COLOUR: u64 = (1 << OBJECT) - 1;

    pub const PATTERN: u64 = 1 << 62;

    /// See `Quality::unguarded_weight`.
    pub const UNGUARDED: u64 = 1 << 63;

    /// [`Sample::UNGUARDED`] in the word of an object's number.
    pub(super) const UNGUARDED_OBJECT: u32 = (Self::UNGUARDED >> OBJECT) as u32;

    /// The threshold that rounds to the nearest step, see [`Sample::pixel`].
    pub const HALF_STEP: u64 = 0x0040_0040_0040;

    pub fn showing(self, object: u32) -> Self {
        Self(self.0 | u64::from(object + 1) << OBJECT)
    }

    pub fn patterned(self) -> Self {
        Self(self.0 | Self::PATTERN)
    }

    pub fn is_patterned(self) -> bool {
        self.0 & Self::PATTERN != 0
    }

    pub fn object(self) -> Option<ObjectId> {
        let label = (self.0 & !(Self::PATTERN | Self::UNGUARDED)) >> OBJECT;
        label.checked_sub(1).map(|i| ObjectId::new(i as usize))
    }

    /// Returns the object's number plus one at each corner of a square. `samples` are from the
    /// upper left corner to the lower right one.
    #[inline(always)]
    pub fn labels(samples: &[u64]) -> u32x4<Baseline> {
        let [upper, lower] = [&samples[..2], &samples[samples.len() - 2..]]
            .map(|pair| u64x2::from_slice(baseline(), pair).bitcast::<u32x4<Baseline>>());
        (upper.unzip_high(lower) << 2) >> (OBJECT - 30)
    }

    /// Returns the mean colour, and the object if the points show the same one.
    pub fn mean(self, other: Self) -> Self {
        // Sums do not carry into the next channel.
        let sums = (self.0 & Self::COLOUR) + (other.0 & Self::COLOUR);
        let colour = (sums >> 1) & (Self::COLOUR ^ 0x8000_8000_8000);
        let object = if self.object() == other.object() { self.0 & !Self::COLOUR } else { 0 };
        Self(colour | object)
    }

    /// Returns the colour as `0x00RRGGBB`. The 16-bit words of `threshold`, 0 to 127 in 128ths of a
    /// step, are added before truncation.
    pub fn pixel(self, threshold: u64) -> u32 {
        let steps = (self.0 + threshold) >> SAMPLE_BITS;
        (steps & 0xff | (steps >> 8) & 0xff00 | (steps >> 16) & 0x00ff_0000) as u32
    }
}

/// Truncates, so that a pixel is the sum rounded once.
#[inline(always)]
pub(super) fn from_sums<S: Isa>(simd: S, sums: &[Sum; 4]) -> [u64; 4] {
    let [a, b, c, d] =
        sums.map(|sum| i32x4::simd_from(simd, sum) >> (STEP_BITS - SAMPLE_BITS) as u32);
    let ([a, b], [c, d]) = (limited(simd, a, b), limited(simd, c, d));
    [a, b, c, d]
}

#[inline(always)]
fn limited<S: Isa>(simd: S, first: i32x4<S>, second: i32x4<S>) -> [u64; 2] {
    let channels = first.saturating_narrow(second);
    let channels = channels.max(i16x8::splat(simd, 0)).min(i16x8::splat(simd, 255 * STEP as i16));
    (channels.bitcast::<u64x2<S>>() & Sample::COLOUR).into()
}

#[cfg(test)]
mod tests {
    use super::Sample;

    #[test]
    fn means_of_unguarded_points_have_the_mean_colour() {
        let [dark, bright] = [0, 0x7f80_7f80_7f80].map(|colour| Sample(colour).showing(5));
        let [a, b] = [dark, bright].map(|point| Sample(point.patterned().0 | Sample::UNGUARDED));
        let flags = a.0 & !Sample::COLOUR;
        assert_eq!(a.mean(b), Sample(0x3fc0_3fc0_3fc0 | flags));
        assert_eq!(a.mean(dark.showing(9)).0 & Sample::COLOUR, 0);
    }
}
