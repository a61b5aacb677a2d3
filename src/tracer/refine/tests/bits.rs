use crate::grid::{Bits, WORDS, each};
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
    fn bits_ends_include_the_next_bit(bits in bits()) {
        let ends = is_set(bits.ends());
        for (i, &end) in ends.iter().enumerate() {
            prop_assert_eq!(end, bits.has(i) || i > 0 && bits.has(i - 1));
        }
    }

    #[test]
    fn bits_halves_repeat_each_bit(bits in bits()) {
        for (i, &half) in is_set(bits.halves()).iter().enumerate() {
            prop_assert_eq!(half, bits.has(i / 2));
        }
    }

    #[test]
    fn bits_masks_have_only_the_range(
        bits in bits(),
        first in 0..COUNT as i32,
        last in -1..COUNT as i32,
    ) {
        let mut called = Vec::new();
        Bits::masks(first, last, |i, mask| each(bits.0[i] & mask, |bit| called.push(64 * i + bit)));
        let expected: Vec<usize> = (first..=last)
            .map(|i| i as usize)
            .filter(|&i| bits.has(i))
            .collect();
        prop_assert_eq!(called, expected);
    }
}
