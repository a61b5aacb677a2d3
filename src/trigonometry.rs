//! Sines, without the 5 kB that a library takes to round every number right, and roots.

use core::f64::consts::TAU;
#[cfg(target_arch = "x86_64")]
use fearless_simd::{f32x4, prelude::*};

/// The square root.
#[must_use]
#[inline(always)]
pub(crate) fn root(x: f32) -> f32 {
    // In place, where `libm`'s is a call, which leaves no register as it was.
    #[cfg(target_arch = "x86_64")]
    if let Some(simd) = fearless_simd::Level::baseline().as_sse2() {
        return f32x4::splat(simd, x).sqrt().as_slice()[0];
    }
    libm::sqrtf(x)
}

/// The sine of an angle in radians, to within 1e-6 for angles to 1e6; not a number for what is none.
#[must_use]
#[inline(never)]
pub fn sin(angle: f32) -> f32 {
    sin_turns(f64::from(angle) / TAU)
}

/// The cosine of an angle in radians, as good as [`sin`].
#[must_use]
#[inline(never)]
pub fn cos(angle: f32) -> f32 {
    sin_turns(f64::from(angle) / TAU + 0.25)
}

#[inline(never)]
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
    for n in &[110_u8, 72, 42, 20, 6] {
        sum = 1.0 - x2 / f64::from(*n) * sum;
    }
    (x * sum) as f32
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
