//! Rows of bits against rows of truth values.

use crate::grid::{Bits, WORDS};
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
    fn halves_are_each_bit_twice(bits in bits()) {
        for (i, &half) in is_set(bits.halves()).iter().enumerate() {
            prop_assert_eq!(half, bits.has(i / 2));
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
