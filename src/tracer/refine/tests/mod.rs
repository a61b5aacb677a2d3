//! The passes over rows against scalar twins, on every instruction set of the machine.

extern crate std;

mod bits;
mod fill;
mod points;
mod verdict;

use super::verdict::Limit;
use crate::grid::Pyramid;
use crate::trace::Sample;
use proptest::prelude::*;
use std::prelude::v1::*;

/// A sample of any colour, often near to others, that shows one of few objects, with a pattern or without.
fn sample() -> impl Strategy<Value = Sample> {
    let channel = || prop_oneof![3 => 16_000_u64..16_400, 1 => 0_u64..=32_640];
    ([channel(), channel(), channel()], 0_u32..3, any::<bool>()).prop_map(
        |([blue, green, red], object, is_patterned)| {
            let sample = Sample(blue | green << 16 | red << 32).showing(object);
            if is_patterned {
                sample.patterned()
            } else {
                sample
            }
        },
    )
}

/// Blue, green and red of a sample.
fn channels(sample: Sample) -> [i32; 3] {
    [0, 16, 32].map(|shift| (sample.0 >> shift & 0xffff) as i32)
}

/// The most that samples are apart in a channel.
fn span(samples: &[Sample]) -> i32 {
    (0..3)
        .map(|channel| {
            let values = samples.iter().map(|&sample| channels(sample)[channel]);
            values.clone().max().unwrap() - values.min().unwrap()
        })
        .max()
        .unwrap()
}

/// A pyramid with two rows of corners in a level, by their samples and keys.
fn two_rows(level: usize, corners: &[[(Sample, u32); 2]]) -> Box<Pyramid> {
    let mut pyramid = Box::new(Pyramid::new());
    for (x, column) in corners.iter().enumerate() {
        for (y, &(sample, key)) in column.iter().enumerate() {
            pyramid.put(Pyramid::index(level, x, y), sample, key);
        }
    }
    pyramid
}

proptest! {
    #[test]
    fn samples_are_within_a_limit_as_far_as_their_channels_are(
        a in sample(),
        b in sample(),
        limit in 0_i32..=32_767,
    ) {
        // A tolerance for squares of 8, in 128ths of a step.
        let has = Limit::new(limit as f32 / 128.0).has(a, b);
        // It may take what is one more for what is as much, since it compares halves.
        prop_assert!(has || span(&[a, b]) > limit - 1);
        prop_assert!(!has || span(&[a, b]) <= limit + 1);
    }
}
