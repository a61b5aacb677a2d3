//! Eight numbers of 16 bits at once, for the mixer: by SSE2, which every x86-64 processor has, and by loops elsewhere.

/// Eight 16-bit integers.
#[derive(Clone, Copy)]
#[cfg(target_arch = "x86_64")]
pub struct Lanes(core::arch::x86_64::__m128i);

#[cfg(target_arch = "x86_64")]
use core::arch::x86_64::*;

/// Calls of instructions of SSE2.
#[cfg(target_arch = "x86_64")]
macro_rules! sse2 {
    ($call:expr) => {
        // SAFETY: every x86-64 processor has SSE2, and none of these calls takes a pointer.
        unsafe { $call }
    };
}

#[cfg(target_arch = "x86_64")]
#[allow(unsafe_code, reason = "instructions by name")]
impl Lanes {
    #[inline(always)]
    pub fn new(&[a, b, c, d, e, f, g, h]: &[i16; 8]) -> Lanes {
        Lanes(sse2!(_mm_set_epi16(h, g, f, e, d, c, b, a)))
    }

    #[inline(always)]
    pub fn splat(number: i16) -> Lanes {
        Lanes(sse2!(_mm_set1_epi16(number)))
    }

    /// The sums, which stop at the ends of 16 bits.
    #[inline(always)]
    pub fn saturating_add(self, other: Lanes) -> Lanes {
        Lanes(sse2!(_mm_adds_epi16(self.0, other.0)))
    }

    /// The upper 16 bits of the products.
    #[inline(always)]
    pub fn multiply_high(self, other: Lanes) -> Lanes {
        Lanes(sse2!(_mm_mulhi_epi16(self.0, other.0)))
    }

    /// The halves, rounded down.
    #[inline(always)]
    pub fn halve(self) -> Lanes {
        Lanes(sse2!(_mm_srai_epi16(self.0, 1)))
    }

    /// The sum of all products of two rows of lanes, modulo 2^32.
    #[inline(always)]
    pub fn dot<const N: usize>(a: [Lanes; N], b: [Lanes; N]) -> i32 {
        let mut sum = sse2!(_mm_setzero_si128());
        for i in 0..N {
            sum = sse2!(_mm_add_epi32(sum, _mm_madd_epi16(a[i].0, b[i].0)));
        }
        sum = sse2!(_mm_add_epi32(sum, _mm_shuffle_epi32(sum, 0x4e)));
        sum = sse2!(_mm_add_epi32(sum, _mm_shuffle_epi32(sum, 0xb1)));
        sse2!(_mm_cvtsi128_si32(sum))
    }
}

/// The same without SSE2. The packer runs on other processors too, where somebody builds for x86-64 on them.
#[cfg(any(test, not(target_arch = "x86_64")))]
mod plain {
    #[derive(Clone, Copy)]
    pub struct Lanes([i16; 8]);

    impl Lanes {
        pub fn new(numbers: &[i16; 8]) -> Lanes {
            Lanes(*numbers)
        }

        pub fn splat(number: i16) -> Lanes {
            Lanes([number; 8])
        }

        pub fn saturating_add(self, other: Lanes) -> Lanes {
            Lanes(core::array::from_fn(|i| {
                self.0[i].saturating_add(other.0[i])
            }))
        }

        pub fn multiply_high(self, other: Lanes) -> Lanes {
            let product = |i| i32::from(self.0[i]) * i32::from(other.0[i]);
            Lanes(core::array::from_fn(|i| (product(i) >> 16) as i16))
        }

        pub fn halve(self) -> Lanes {
            Lanes(self.0.map(|number| number >> 1))
        }

        pub fn dot<const N: usize>(a: [Lanes; N], b: [Lanes; N]) -> i32 {
            let pairs = a.iter().zip(&b).flat_map(|(a, b)| a.0.iter().zip(&b.0));
            pairs.fold(0, |sum: i32, (&a, &b)| {
                sum.wrapping_add(i32::from(a) * i32::from(b))
            })
        }
    }
}

#[cfg(not(target_arch = "x86_64"))]
pub use plain::Lanes;

#[cfg(all(test, target_arch = "x86_64"))]
mod tests {
    use super::{Lanes, plain};
    use proptest::prelude::*;

    /// The numbers of lanes, each by its product with 1 alone.
    fn numbers(lanes: Lanes) -> [i32; 8] {
        core::array::from_fn(|i| {
            let mut one = [0; 8];
            one[i] = 1;
            Lanes::dot([lanes], [Lanes::new(&one)])
        })
    }

    fn plain_numbers(lanes: plain::Lanes) -> [i32; 8] {
        core::array::from_fn(|i| {
            let mut one = [0; 8];
            one[i] = 1;
            plain::Lanes::dot([lanes], [plain::Lanes::new(&one)])
        })
    }

    proptest! {
        #[test]
        fn every_processor_computes_the_same(a: [i16; 8], b: [i16; 8], c: i16) {
            let (x, y) = (Lanes::new(&a), Lanes::new(&b));
            let (p, q) = (plain::Lanes::new(&a), plain::Lanes::new(&b));
            prop_assert_eq!(Lanes::dot([x, y], [y, y]), plain::Lanes::dot([p, q], [q, q]));
            prop_assert_eq!(numbers(x.saturating_add(y)), plain_numbers(p.saturating_add(q)));
            prop_assert_eq!(numbers(x.multiply_high(y)), plain_numbers(p.multiply_high(q)));
            prop_assert_eq!(numbers(x.halve()), plain_numbers(p.halve()));
            prop_assert_eq!(numbers(Lanes::splat(c)), plain_numbers(plain::Lanes::splat(c)));
        }
    }
}
