//! Roots, sines, rounding and easing of single numbers.
//!
//! `core` has no such functions, so these are either correctly rounded, as the square root is everywhere, or sums and
//! products alone: the same bits on every platform.

use crate::lanes::*;
use core::f64::consts::TAU;
use fearless_simd::f32x4;

/// The square root, correctly rounded.
#[must_use]
#[inline(always)]
pub(crate) fn sqrt(x: f32) -> f32 {
    // An instruction, where `libm`'s is a call and a loop.
    f32x4::splat(baseline(), x).sqrt().as_slice()[0]
}

/// The sine of an angle in radians, to within 1e-6 for angles to 1e6; not a number for what is none.
///
/// `libm`'s is as good for larger angles too, by 2.8 kB of digits of pi that no packer makes smaller.
#[must_use]
pub(crate) fn sin(angle: f32) -> f32 {
    sin_turns(f64::from(angle) / TAU)
}

/// The cosine of an angle in radians, as good as [`sin`].
#[must_use]
pub(crate) fn cos(angle: f32) -> f32 {
    sin_turns(f64::from(angle) / TAU + 0.25)
}

/// The sine of an angle in turns.
fn sin_turns(turns: f64) -> f32 {
    let half = if turns < 0.0 { -0.5 } else { 0.5 };
    // Half a turn to either side, then a quarter: sin(1/2 - t) = sin(t).
    let t = turns - (turns + half) as i64 as f64;
    let t = if t > 0.25 {
        0.5 - t
    } else if t < -0.25 {
        -0.5 - t
    } else {
        t
    };
    // Taylor's series; the first term left out is below 6e-8.
    let x = t * TAU;
    let x2 = x * x;
    let mut sum = 1.0;
    for n in [110.0, 72.0, 42.0, 20.0, 6.0] {
        sum = 1.0 - x2 / n * sum;
    }
    (x * sum) as f32
}

/// 2 to the power `x`.
#[must_use]
pub(crate) fn exp2(x: f32) -> f32 {
    libm::exp2f(x)
}

/// 1.5 * 2^23: what is added to a number between -2^22 and 2^22 is rounded to the nearest integer, which is in the low bits
/// of the sum; taking it off again leaves that integer as a number.
pub(crate) const ROUND_TO_INTEGER: f32 = 12_582_912.0;

/// The nearest integer to a number between -2^22 and 2^22; a tie rounds to even.
#[must_use]
#[inline(always)]
pub(crate) fn round(x: f32) -> f32 {
    (x + ROUND_TO_INTEGER) - ROUND_TO_INTEGER
}

/// Hermite's smooth step: 0 up to 0, 1 from 1 on, level at both ends.
#[must_use]
pub(crate) fn smooth_step(u: f32) -> f32 {
    let u = u.clamp(0.0, 1.0);
    u * u * (3.0 - 2.0 * u)
}

#[cfg(test)]
mod tests {
    use super::{cos, sin};

    #[test]
    fn sines_are_within_a_millionth() {
        let wide = (-2_000_000..=2_000_000).map(|i| i as f32 * 0.5);
        let dense = (-1_000_000..=1_000_000).map(|i| i as f32 * 1e-5);
        for angle in wide.chain(dense) {
            let exact = libm::sin(f64::from(angle));
            assert!((f64::from(sin(angle)) - exact).abs() < 1e-6, "sin {angle}");
            let exact = libm::cos(f64::from(angle));
            assert!((f64::from(cos(angle)) - exact).abs() < 1e-6, "cos {angle}");
        }
    }
}
