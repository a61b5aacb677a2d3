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

    /// Adds the products of two lanes to these, which are four numbers of 32 bits.
    #[inline(always)]
    pub fn add_products(self, a: Lanes, b: Lanes) -> Lanes {
        Lanes(sse2!(_mm_add_epi32(self.0, _mm_madd_epi16(a.0, b.0))))
    }

    /// The sum of four numbers of 32 bits, modulo 2^32.
    #[inline(always)]
    pub fn sum(self) -> i32 {
        let mut sum = self.0;
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

        pub fn add_products(self, a: Lanes, b: Lanes) -> Lanes {
            let product = |i: usize| i32::from(a.0[i]) * i32::from(b.0[i]);
            let sums = self.wide();
            let sum = |i| {
                product(2 * i)
                    .wrapping_add(product(2 * i + 1))
                    .wrapping_add(sums[i])
            };
            let sums: [i32; 4] = core::array::from_fn(sum);
            Lanes(core::array::from_fn(|i| {
                (sums[i / 2] >> (16 * (i % 2))) as i16
            }))
        }

        pub fn sum(self) -> i32 {
            self.wide().into_iter().fold(0, i32::wrapping_add)
        }

        fn wide(self) -> [i32; 4] {
            core::array::from_fn(|i| {
                i32::from(self.0[2 * i] as u16) | i32::from(self.0[2 * i + 1]) << 16
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
            Lanes::splat(0).add_products(lanes, Lanes::new(&one)).sum()
        })
    }

    fn plain_numbers(lanes: plain::Lanes) -> [i32; 8] {
        core::array::from_fn(|i| {
            let mut one = [0; 8];
            one[i] = 1;
            plain::Lanes::splat(0)
                .add_products(lanes, plain::Lanes::new(&one))
                .sum()
        })
    }

    proptest! {
        #[test]
        fn every_processor_computes_the_same(a: [i16; 8], b: [i16; 8], c: i16) {
            let (x, y) = (Lanes::new(&a), Lanes::new(&b));
            let (p, q) = (plain::Lanes::new(&a), plain::Lanes::new(&b));
            let products = Lanes::splat(c).add_products(x, y).add_products(y, y);
            let plain_products = plain::Lanes::splat(c).add_products(p, q).add_products(q, q);
            prop_assert_eq!(products.sum(), plain_products.sum());
            prop_assert_eq!(numbers(x.saturating_add(y)), plain_numbers(p.saturating_add(q)));
            prop_assert_eq!(numbers(x.multiply_high(y)), plain_numbers(p.multiply_high(q)));
            prop_assert_eq!(numbers(x.halve()), plain_numbers(p.halve()));
            prop_assert_eq!(numbers(Lanes::splat(c)), plain_numbers(plain::Lanes::splat(c)));
        }
    }
}
