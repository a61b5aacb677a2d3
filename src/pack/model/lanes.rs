//! Vectors of eight `i16` or four `i32`: SSE2 on x86-64, loops elsewhere.

#[derive(Clone, Copy)]
#[cfg(target_arch = "x86_64")]
pub struct Lanes(core::arch::x86_64::__m128i);

#[cfg(target_arch = "x86_64")]
use core::arch::x86_64::*;

#[cfg(target_arch = "x86_64")]
macro_rules! sse2 {
    ($call:expr) => {
        // SAFETY: every x86-64 processor has SSE2, and none of these calls takes a pointer.
        unsafe { $call }
    };
}

#[cfg(target_arch = "x86_64")]
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

#[cfg(target_arch = "x86_64")]
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
    pub fn limit(self, most: i16) -> Lanes {
        let (least, most) = (Lanes::splat(-most).0, Lanes::splat(most).0);
        Lanes(sse2!(_mm_max_epi16(_mm_min_epi16(self.0, most), least)))
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

#[cfg(any(test, not(target_arch = "x86_64")))]
mod plain {
    use core::array::from_fn;

    #[derive(Clone, Copy)]
    pub struct Lanes([i16; 8]);

    impl Lanes {
        pub fn new(numbers: &[i16; 8]) -> Lanes {
            Lanes(*numbers)
        }

        pub fn pairs(pairs: &[u32; 4]) -> Lanes {
            Lanes(from_fn(|i| (pairs[i / 2] >> (16 * (i % 2))) as i16))
        }

        pub fn to_pairs(self) -> [u32; 4] {
            from_fn(|i| u32::from(self.0[2 * i] as u16) | (self.0[2 * i + 1] as u32) << 16)
        }

        pub fn splat(number: i16) -> Lanes {
            Lanes([number; 8])
        }

        pub fn splat_pair(pair: u32) -> Lanes {
            Lanes::pairs(&[pair; 4])
        }

        fn zip(self, other: Lanes, operation: impl Fn(i16, i16) -> i16) -> Lanes {
            Lanes(from_fn(|i| operation(self.0[i], other.0[i])))
        }

        pub fn and(self, other: Lanes) -> Lanes {
            self.zip(other, |a, b| a & b)
        }

        pub fn xor(self, other: Lanes) -> Lanes {
            self.zip(other, |a, b| a ^ b)
        }

        pub fn add(self, other: Lanes) -> Lanes {
            self.zip(other, i16::wrapping_add)
        }

        pub fn subtract(self, other: Lanes) -> Lanes {
            self.zip(other, i16::wrapping_sub)
        }

        pub fn saturating_add(self, other: Lanes) -> Lanes {
            self.zip(other, i16::saturating_add)
        }

        pub fn multiply_high(self, other: Lanes) -> Lanes {
            self.zip(other, |a, b| ((i32::from(a) * i32::from(b)) >> 16) as i16)
        }

        pub fn multiply_high_unsigned(self, other: Lanes) -> Lanes {
            let wide = |number| u32::from(number as u16);
            self.zip(other, |a, b| ((wide(a) * wide(b)) >> 16) as i16)
        }

        pub fn to_numbers(self) -> [i16; 8] {
            self.0
        }

        pub fn limit(self, most: i16) -> Lanes {
            Lanes(self.0.map(|number| number.clamp(-most, most)))
        }

        pub fn halve(self) -> Lanes {
            Lanes(self.0.map(|number| number >> 1))
        }

        pub fn shift_left<const BITS: i32>(self) -> Lanes {
            Lanes::pairs(&self.to_pairs().map(|pair| pair << BITS))
        }

        pub fn shift_right<const BITS: i32>(self) -> Lanes {
            Lanes::pairs(&self.to_pairs().map(|pair| (pair as i32 >> BITS) as u32))
        }

        pub fn add_products(self, a: Lanes, b: Lanes) -> Lanes {
            let sums = self.to_pairs();
            let product = |i| i32::from(a.0[i]) * i32::from(b.0[i]);
            let products = |i| product(2 * i).wrapping_add(product(2 * i + 1));
            Lanes::pairs(&from_fn(|i| sums[i].wrapping_add(products(i) as u32)))
        }

        pub fn sum(self) -> i32 {
            self.to_pairs().into_iter().fold(0, u32::wrapping_add) as i32
        }
    }
}

#[cfg(not(target_arch = "x86_64"))]
pub use plain::Lanes;

#[cfg(all(test, target_arch = "x86_64"))]
mod tests {
    use super::{Lanes, plain};
    use proptest::prelude::*;

    macro_rules! assert_same {
        ($x:ident, $y:ident, $p:ident, $q:ident: $($operation:ident)*) => {
            $(prop_assert_eq!($x.$operation($y).to_pairs(), $p.$operation($q).to_pairs());)*
        };
    }

    proptest! {
        #[test]
        fn sse2_matches_plain_loops(a: [i16; 8], b: [i16; 8], c: i16, d: u32) {
            let (x, y) = (Lanes::new(&a), Lanes::new(&b));
            let (p, q) = (plain::Lanes::new(&a), plain::Lanes::new(&b));
            assert_same!(x, y, p, q: and xor add subtract saturating_add);
            assert_same!(x, y, p, q: multiply_high multiply_high_unsigned);
            prop_assert_eq!(x.halve().to_pairs(), p.halve().to_pairs());
            prop_assert_eq!(x.shift_left::<3>().to_pairs(), p.shift_left::<3>().to_pairs());
            prop_assert_eq!(x.shift_right::<9>().to_pairs(), p.shift_right::<9>().to_pairs());
            prop_assert_eq!(x.to_numbers(), a);
            prop_assert_eq!(p.to_numbers(), a);
            prop_assert_eq!(x.limit(700).to_numbers(), p.limit(700).to_numbers());
            prop_assert_eq!(Lanes::splat(c).to_pairs(), plain::Lanes::splat(c).to_pairs());
            prop_assert_eq!(Lanes::splat_pair(d).to_pairs(), plain::Lanes::splat_pair(d).to_pairs());
            prop_assert_eq!(Lanes::pairs(&x.to_pairs()).to_pairs(), x.to_pairs());
            let products = Lanes::splat(c).add_products(x, y).add_products(y, y);
            let plain_products = plain::Lanes::splat(c).add_products(p, q).add_products(q, q);
            prop_assert_eq!(products.to_pairs(), plain_products.to_pairs());
            prop_assert_eq!(products.sum(), plain_products.sum());
        }
    }
}
