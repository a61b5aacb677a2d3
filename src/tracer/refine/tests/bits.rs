//! Rows of bits against rows of truth values.

use super::super::bits::{Bits, WORDS};
use proptest::prelude::*;
use std::prelude::v1::*;

extern crate std;

const COUNT: usize = 64 * WORDS;

fn bits() -> impl Strategy<Value = Bits> {
    any::<[u64; WORDS]>().prop_map(Bits)
}

fn is_set(bits: Bits) -> Vec<bool> {
    (0..COUNT).map(|i| bits.has(i)).collect()
}

proptest! {
    #[test]
    fn ends_are_each_bit_and_the_one_after_it(bits in bits()) {
        let ends = is_set(bits.ends());
        for (i, &end) in ends.iter().enumerate() {
            prop_assert_eq!(end, bits.has(i) || i > 0 && bits.has(i - 1));
        }
    }

    #[test]
    fn parts_are_each_bit_so_many_times(bits in bits(), count in 2_usize..=31) {
        let parts = is_set((bits & Bits::first(COUNT / count)).parts(count));
        for (i, &part) in parts.iter().enumerate() {
            prop_assert_eq!(part, i / count < COUNT / count && bits.has(i / count));
        }
    }

    #[test]
    fn multiples_are_what_the_divisor_divides(divisor in 2_usize..=31) {
        for (i, &multiple) in is_set(Bits::multiples(divisor)).iter().enumerate() {
            prop_assert_eq!(multiple, i % divisor == 0);
        }
    }

    #[test]
    fn every_bit_that_is_set_is_called_for_in_order(bits in bits()) {
        let mut called = Vec::new();
        bits.for_each(|i| called.push(i));
        let expected: Vec<usize> = (0..COUNT).filter(|&i| bits.has(i)).collect();
        prop_assert_eq!(called, expected);
    }

    #[test]
    fn bits_in_a_range_are_called_for_and_no_others(
        bits in bits(),
        first in 0..COUNT as i32,
        last in -1..COUNT as i32,
    ) {
        let mut called = Vec::new();
        bits.for_each_in(first, last, |i| called.push(i));
        let expected: Vec<usize> = (first..=last)
            .map(|i| i as usize)
            .filter(|&i| bits.has(i))
            .collect();
        prop_assert_eq!(called, expected);
    }
}
