use super::super::Kernels;
use super::super::verdict::{Verdict, growth, limits};
use super::{sample, span, two_rows};
use crate::grid::Bits;
use crate::lanes::isas;
use crate::quality::Quality;
use crate::trace::Sample;
use proptest::prelude::*;

/// Returns whether the square is agreeing, flat, filled and patterned.
fn verdict(quality: &Quality, side: usize, corners: [(Sample, u32); 4]) -> [bool; 4] {
    let samples = corners.map(|(sample, _)| sample);
    let agreeing = corners.iter().all(|&(_, key)| key == corners[0].1);
    let rounded = |sample: &Sample| sample.pixel(Sample::HALF_STEP);
    let flat = samples.iter().all(|s| rounded(s) == rounded(&samples[0]));
    let tolerance = if agreeing { quality.tolerance_agreeing } else { quality.tolerance_differing };
    let most = (tolerance * 8.0 * 128.0 / side as f32) as i32;
    let patterned = samples.iter().any(|sample| sample.is_patterned());
    [agreeing, flat, flat || span(&samples) <= most, patterned]
}

extern crate std;

proptest! {
    #[test]
    fn verdict_on_rows_equals_single_squares(
        level in 1_usize..=5,
        columns in proptest::collection::vec([(sample(), 0_u32..2), (sample(), 0_u32..2)], 2..17),
        squares in any::<u64>(),
        tolerance_agreeing in prop_oneof![0.0_f32..20.0, Just(f32::INFINITY)],
        tolerance_differing in prop_oneof![0.0_f32..20.0, Just(0.0)],
    ) {
        let quality = Quality { tolerance_agreeing, tolerance_differing, ..Quality::DEFAULT };
        let pyramid = two_rows(level, &columns);
        let count = columns.len() - 1;
        let mut squares = Bits([squares; _]);
        squares = squares & Bits::first(count);
        for (isa, kernels) in isas().map(|isa| (isa, Kernels::narrow(isa))) {
            let limits = limits(&quality, growth(1 << level, 0.0));
            let (above, below) = (pyramid.row(level, 0), pyramid.row(level, 1));
            let all = kernels.judge(limits, &squares, above, below);
            let Verdict { agreeing, flat, filled, patterned } = all;
            for x in 0..count {
                let ([a, c], [b, d]) = (columns[x], columns[x + 1]);
                let alone = verdict(&quality, 1 << level, [a, b, c, d]).map(|is| is && squares.has(x));
                let together = [agreeing, flat, filled, patterned].map(|bits| bits.has(x));
                prop_assert_eq!(alone, together, "square {} by {:?}", x, isa);
            }
        }
    }
}
