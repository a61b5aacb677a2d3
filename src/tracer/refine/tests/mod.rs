//! Compares the passes over rows with scalar code, on every instruction set of the machine.

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

/// Draws samples of few objects, often of similar colours, with or without a pattern.
fn sample() -> impl Strategy<Value = Sample> {
    let channel = || prop_oneof![3 => 16_000_u64..16_400, 1 => 0_u64..=32_640];
    ([channel(), channel(), channel()], 0_u32..3, any::<bool>()).prop_map(
        |([blue, green, red], object, is_patterned)| {
            let sample = Sample(blue | green << 16 | red << 32).showing(object);
            if is_patterned { sample.patterned() } else { sample }
        },
    )
}

fn channels(sample: Sample) -> [i32; 3] {
    [0, 16, 32].map(|shift| (sample.0 >> shift & 0xffff) as i32)
}

fn span(samples: &[Sample]) -> i32 {
    (0..3)
        .map(|channel| {
            let values = samples.iter().map(|&sample| channels(sample)[channel]);
            values.clone().max().unwrap() - values.min().unwrap()
        })
        .max()
        .unwrap()
}

/// Returns a pyramid with two rows of corners in a level.
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
    fn limit_compares_all_channels(
        a in sample(),
        b in sample(),
        limit in 0_i32..=32_767,
    ) {
        // In 128ths of a step.
        let has = Limit::new(limit as f32 / 128.0).has(a, b);
        // Comparing halves may accept one more.
        prop_assert!(has || span(&[a, b]) > limit - 1);
        prop_assert!(!has || span(&[a, b]) <= limit + 1);
    }
}
