//! Scalar functions that `core` lacks. Public ones use only correctly rounded operations: the same
//! bits on every platform.

pub use crate::lanes::ROUND_TO_INTEGER;

use crate::lanes::*;
use core::f64::consts::TAU;
use fearless_simd::f32x4;
use glam::Vec3A;

/// Converts a number below 2^24 exactly. Via `i32` it is a single instruction, unlike from `usize`.
#[inline(always)]
pub(crate) fn to_f32(count: usize) -> f32 {
    count as i32 as f32
}

/// Returns the square root, correctly rounded.
#[must_use]
#[inline(always)]
pub fn sqrt(x: f32) -> f32 {
    // A single instruction; `libm` calls a function with a loop.
    f32x4::splat(baseline(), x).sqrt().as_slice()[0]
}

/// Returns the sine of an angle in radians, accurate to 1e-6 up to 1e6; NaN for NaN and infinity.
/// `libm` has 2.8 kB of digits of pi for larger angles.
#[must_use]
pub fn sin(angle: f32) -> f32 {
    sin_turns(f64::from(angle) / TAU)
}

/// Returns the cosine of an angle in radians, as accurate as [`sin`].
#[must_use]
pub fn cos(angle: f32) -> f32 {
    sin_turns(f64::from(angle) / TAU + 0.25)
}

// Optimised for size: not called per pixel.
#[inline(never)]
fn sin_turns(turns: f64) -> f32 {
    let half = if turns < 0.0 { -0.5 } else { 0.5 };
    // Reduced to -1/2 to 1/2 turns, then to -1/4 to 1/4 by sin(1/2 - t) = sin(t).
    let t = turns - (turns + half) as i64 as f64;
    let t = if t > 0.25 {
        0.5 - t
    } else if t < -0.25 {
        -0.5 - t
    } else {
        t
    };
    // Taylor's series. The first omitted term is below 6e-8.
    let x = t * TAU;
    let x2 = x * x;
    let mut sum = 1.0;
    for n in [110.0, 72.0, 42.0, 20.0, 6.0] {
        sum = 1.0 - x2 / n * sum;
    }
    (x * sum) as f32
}

/// Returns the logarithm to base 2 of a positive normal number, to 0.0003.
#[must_use]
pub(crate) fn log2(x: f32) -> f32 {
    let simd = baseline();
    crate::lanes::log2(simd, splat(simd, x)).as_slice()[0]
}

/// Rounds a number between -2^22 and 2^22 to the nearest integer; a tie rounds to even.
#[must_use]
#[inline(always)]
pub fn round(x: f32) -> f32 {
    (x + ROUND_TO_INTEGER) - ROUND_TO_INTEGER
}

/// Returns Hermite's smooth step: 0 for `u` up to 0, 1 from 1 on, and `u^2 (3 - 2 u)` between, with
/// slope 0 at both ends.
#[must_use]
// Saves 8 packed bytes; hot code uses lanes.
#[inline(never)]
pub fn smooth_step(u: f32) -> f32 {
    let u = u.clamp(0.0, 1.0);
    u * u * (3.0 - 2.0 * u)
}

/// NaN or infinite for zero, where `Vec3A::normalize` panics with glam's feature `glam-assert`.
pub(crate) fn unit(v: Vec3A) -> Vec3A {
    v * v.length_recip()
}

#[cfg(test)]
mod tests {
    use super::{cos, log2, sin};

    #[test]
    fn log2_error_is_below_3e_4() {
        for i in -3_000..=3_000 {
            let x = libm::exp2f(i as f32 * 0.04);
            assert!((log2(x) - libm::log2f(x)).abs() < 3e-4, "log2 {x}");
        }
    }

    #[test]
    fn sin_and_cos_errors_are_below_1e_6() {
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
