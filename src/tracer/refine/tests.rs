//! Compares filled squares with interpolation in real numbers, on every instruction set of the
//! machine.

extern crate std;

use super::Kernels;
use super::fill::Run;
use crate::grid::Bits;
use crate::lanes::isas;
use crate::picture::Band;
use crate::prepare::ROUND;
use crate::trace::Sample;
use proptest::prelude::*;

/// Draws samples, often of similar colours.
fn sample() -> impl Strategy<Value = Sample> {
    let channel = || prop_oneof![3 => 16_000_u64..16_400, 1 => 0_u64..=32_640];
    [channel(), channel(), channel()]
        .prop_map(|[blue, green, red]| Sample(blue | green << 16 | red << 32))
}

fn channels(sample: Sample) -> [i32; 3] {
    [0, 16, 32].map(|shift| (sample.0 >> shift & 0xffff) as i32)
}

proptest! {
    #[test]
    fn fill_is_bilinear_and_clipped_to_the_picture(
        level in 1_usize..=5,
        corners in [[sample(), sample()], [sample(), sample()]],
        is_flat in any::<bool>(),
        (x, y) in (0_usize..40, 0_usize..40),
    ) {
        let (width, side) = (50, 1_usize << level);
        let [above, below] = corners.map(|row| row.map(|sample| sample.0));
        let mut flat = Bits::NONE;
        if is_flat {
            flat.set(0);
        }
        for kernels in isas().map(Kernels::narrow) {
            const UNDRAWN: u32 = u32::MAX;
            let mut pixels = [UNDRAWN; 50 * 45];
            let mut band = Band { pixels: &mut pixels, stride: width, width, ..Band::none() };
            let filled = Bits::below(1);
            let run = Run { x, y, level, above: &above, below: &below, filled, flat, dither: &ROUND };
            (kernels.fill)(kernels.level, &mut band, &run);
            for (i, &pixel) in pixels.iter().enumerate() {
                let (i, j) = (i % width, i / width);
                let is_in = (x..x + side).contains(&i) && (y..y + side).contains(&j);
                if !is_in {
                    prop_assert_eq!(pixel, UNDRAWN);
                    continue;
                }
                let share = |i: usize| if is_flat { 0.0 } else { i as f64 / side as f64 };
                let (s, t) = (share(i - x), share(j - y));
                prop_assert_eq!(pixel >> 24, 0);
                for channel in 0..3 {
                    let at = |row: usize, column: usize| {
                        f64::from(channels(corners[row][column])[channel]) / 128.0
                    };
                    let row = |row: usize| at(row, 0) * (1.0 - s) + at(row, 1) * s;
                    let expected = row(0) * (1.0 - t) + row(1) * t;
                    let drawn = f64::from(pixel >> (8 * channel) & 0xff);
                    // Rounding, and 31 steps along each side, each off by half a 256th.
                    prop_assert!((drawn - expected).abs() <= 0.5 + 62.0 / 512.0);
                }
            }
        }
    }
}
