//! What is known of a traced point.

use crate::lanes::*;

/// A traced point: its colour, 0 to 255 per channel and not rounded, and its key.
#[derive(Clone, Copy, Default)]
#[repr(align(16))]
pub(crate) struct Sample {
    pub colour: [f32; 3],
    pub key: u32,
}

impl Sample {
    /// No sample.
    pub const NONE: Self = Self {
        colour: [0.0; 3],
        key: 0,
    };

    /// The colour as a pixel, `0x00RRGGBB`, rounded.
    #[inline(always)]
    pub fn pixel(&self) -> u32 {
        let [r, g, b] = self.colour;
        let byte = |c: f32| (c + 0.5) as i32 as u32;
        byte(r) << 16 | byte(g) << 8 | byte(b)
    }

    /// The colour at share `v` of the way from one sample to another.
    #[inline(always)]
    pub fn between(a: &Self, b: &Self, v: f32) -> [f32; 3] {
        core::array::from_fn(
            #[inline(always)]
            |k| a.colour[k] + (b.colour[k] - a.colour[k]) * v,
        )
    }
}

/// Eight samples.
pub(crate) struct SampleLanes<S: Simd> {
    pub colour: Vec3x<S>,
    pub key: U<S>,
}

impl<S: Simd> SampleLanes<S> {
    /// The colours as pixels, `0x00RRGGBB`, rounded.
    #[inline(always)]
    pub fn pixels(&self) -> U<S> {
        byte(self.colour.x) << 16 | byte(self.colour.y) << 8 | byte(self.colour.z)
    }

    /// One after the other.
    #[inline(always)]
    pub fn to_array(&self) -> [Sample; LANES] {
        let r = self.colour.x.to_array();
        let g = self.colour.y.to_array();
        let b = self.colour.z.to_array();
        let key = self.key.to_array();
        core::array::from_fn(
            #[inline(always)]
            |i| Sample {
                colour: [r[i], g[i], b[i]],
                key: key[i],
            },
        )
    }
}

/// Numbers from 0 to 255, rounded.
#[inline(always)]
fn byte<S: Simd>(c: F<S>) -> U<S> {
    let i: I<S> = (c + 0.5).to_int();
    i.bitcast()
}
