//! Vectors of eight `i16` or four `i32` by SSE2.

use core::arch::x86_64::*;

#[derive(Clone, Copy)]
pub struct Lanes(__m128i);

macro_rules! sse2 {
    ($call:expr) => {
        // SAFETY: every x86-64 processor has SSE2, and none of these calls takes a pointer.
        unsafe { $call }
    };
}

macro_rules! operations {
    ($($(#[$doc:meta])* $name:ident: $instruction:ident,)*) => {
        $(
            $(#[$doc])*
            #[inline(always)]
            pub fn $name(self, other: Lanes) -> Lanes {
                Lanes(sse2!($instruction(self.0, other.0)))
            }
        )*
    };
}

#[allow(unsafe_code, reason = "SSE2 intrinsics")]
impl Lanes {
    #[inline(always)]
    pub fn new(&[a, b, c, d, e, f, g, h]: &[i16; 8]) -> Lanes {
        Lanes(sse2!(_mm_set_epi16(h, g, f, e, d, c, b, a)))
    }

    /// Loads eight `i16`, two per `u32`, the first in the low half.
    #[inline(always)]
    pub fn pairs(pairs: &[u32; 4]) -> Lanes {
        let [a, b, c, d] = pairs.map(|pair| pair as i32);
        Lanes(sse2!(_mm_set_epi32(d, c, b, a)))
    }

    #[inline(always)]
    pub fn to_pairs(self) -> [u32; 4] {
        // SAFETY: both types allow any 128 bits.
        unsafe { core::mem::transmute::<__m128i, [u32; 4]>(self.0) }
    }

    #[inline(always)]
    pub fn to_numbers(self) -> [i16; 8] {
        // SAFETY: both types allow any 128 bits.
        unsafe { core::mem::transmute::<__m128i, [i16; 8]>(self.0) }
    }

    #[inline(always)]
    pub fn splat(number: i16) -> Lanes {
        Lanes::splat_pair(u32::from(number as u16) * 0x1_0001)
    }

    /// Repeats `pair`, hidden from the compiler, which would emit a 16-byte constant.
    #[inline(always)]
    pub fn splat_pair(mut pair: u32) -> Lanes {
        // SAFETY: it does nothing.
        unsafe {
            core::arch::asm!("/* {0:e} */", inout(reg) pair, options(pure, nomem, nostack, preserves_flags));
        }
        Lanes(sse2!(_mm_set1_epi32(pair as i32)))
    }

    operations! {
        and: _mm_and_si128,
        xor: _mm_xor_si128,
        /// Wraps around.
        add: _mm_add_epi16,
        /// Wraps around.
        subtract: _mm_sub_epi16,
        saturating_add: _mm_adds_epi16,
        multiply_high: _mm_mulhi_epi16,
        /// Unsigned.
        multiply_high_unsigned: _mm_mulhi_epu16,
    }

    #[inline(always)]
    pub fn limit(self, max: i16) -> Lanes {
        let (min, max) = (Lanes::splat(-max).0, Lanes::splat(max).0);
        Lanes(sse2!(_mm_max_epi16(_mm_min_epi16(self.0, max), min)))
    }

    #[inline(always)]
    pub fn halve(self) -> Lanes {
        Lanes(sse2!(_mm_srai_epi16(self.0, 1)))
    }

    #[inline(always)]
    pub fn shift_left<const BITS: i32>(self) -> Lanes {
        Lanes(sse2!(_mm_slli_epi32::<BITS>(self.0)))
    }

    #[inline(always)]
    pub fn shift_right<const BITS: i32>(self) -> Lanes {
        Lanes(sse2!(_mm_srai_epi32::<BITS>(self.0)))
    }

    /// Adds the products of `a` and `b`, summed in pairs, to four 32-bit lanes.
    #[inline(always)]
    pub fn add_products(self, a: Lanes, b: Lanes) -> Lanes {
        Lanes(sse2!(_mm_add_epi32(self.0, _mm_madd_epi16(a.0, b.0))))
    }

    #[inline(always)]
    pub fn sum(self) -> i32 {
        let mut sum = self.0;
        sum = sse2!(_mm_add_epi32(sum, _mm_shuffle_epi32(sum, 0x4e)));
        sum = sse2!(_mm_add_epi32(sum, _mm_shuffle_epi32(sum, 0xb1)));
        sse2!(_mm_cvtsi128_si32(sum))
    }
}
