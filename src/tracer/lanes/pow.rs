use super::types::*;

/// Returns `x` to the power `h`, for `x` in 1e-6..=1.001 and `h` in 1..=1000.
///
/// Computes `exp2(h log2 x)` with the polynomials of Moshier's Cephes (`logf`, `exp2f`). The
/// relative error is below `1e-6 + 1.2e-7 h |log2 x|`; results below 2^-126 become 2^-126.
#[inline(always)]
pub(crate) fn pow<S: Simd>(simd: S, x: F<S>, h: F<S>) -> F<S> {
    exp2(simd, h * log2(simd, x))
}

/// Defined for positive normal numbers.
#[inline(always)]
pub(crate) fn log2<S: Simd>(simd: S, x: F<S>) -> F<S> {
    // x = 2^e m with m in sqrt(1/2)..sqrt(2): the series about 1 is short.
    let bits: I<S> = x.bitcast();
    let e = (bits - SQRT_HALF_BITS) >> 23;
    let m: F<S> = (bits - (e << 23)).bitcast();
    let t = m - 1.0;
    let p = polynomial(
        simd,
        t,
        &[
            7.037_683_6e-2,
            -1.151_461e-1,
            1.167_699_9e-1,
            -1.242_014_1e-1,
            1.424_932_3e-1,
            -1.666_805_8e-1,
            2.000_071_5e-1,
            -2.499_999_4e-1,
            3.333_333e-1,
        ],
    );
    let t2 = t * t;
    let ln = (t2 * t).mul_add(p, t2.mul_add(splat(simd, -0.5), t));
    ln.mul_add(splat(simd, core::f32::consts::LOG2_E), e.to_float::<F<S>>())
}

const SQRT_HALF_BITS: i32 = 0x3f35_04f3;

/// Returns 2 to the power `y`, for `y` up to 127; 2^-126 below -126.
#[inline(always)]
fn exp2<S: Simd>(simd: S, y: F<S>) -> F<S> {
    let y = y.max(splat(simd, -126.0)).min(splat(simd, 127.0));
    let shifted = y + ROUND_TO_INTEGER;
    let f = y - (shifted - ROUND_TO_INTEGER);
    let p = polynomial(
        simd,
        f,
        &[
            1.535_336_2e-4,
            1.339_887_5e-3,
            9.618_437e-3,
            5.550_332_5e-2,
            2.402_265e-1,
            6.931_472e-1,
            1.0,
        ],
    );
    let whole: I<S> = shifted.bitcast();
    let bits: I<S> = p.bitcast();
    (bits + (whole << 23)).bitcast()
}

#[inline(always)]
fn polynomial<S: Simd>(simd: S, x: F<S>, coefficients: &[f32]) -> F<S> {
    let mut p = splat(simd, coefficients[0]);
    for &c in &coefficients[1..] {
        p = p.mul_add(x, splat(simd, c));
    }
    p
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::*;
    use crate::lanes::isas;
    use fearless_simd::dispatch;

    #[inline(always)]
    fn assert_errors_are_small<S: Simd>(simd: S) {
        // One in 997 of all floats from 1e-6 to 1.001, and 10,000 consecutive ones around 1.
        let (first, last) = (1e-6_f32.to_bits(), 1.001_f32.to_bits());
        let dense = 1_f32.to_bits() - 5000..1_f32.to_bits() + 5000;
        let sparse = (first..=last).step_by(997);
        for x in sparse.chain(dense).map(f32::from_bits) {
            let log2 = libm::log2(f64::from(x));
            for h in [1.0, 1.5, 2.0, 10.0, 40.0, 80.0, 100.0, 333.3, 1000.0] {
                let result = pow(simd, splat(simd, x), splat(simd, h)).as_slice()[0];
                let exact = libm::exp2((f64::from(h) * log2).max(-126.0));
                let allowed = 1e-6 + 1.2e-7 * f64::from(h) * log2.abs();
                let error = (f64::from(result) / exact - 1.0).abs();
                assert!(error <= allowed, "{x} to the {h}: {result} for {exact}");
            }
        }
    }

    #[test]
    fn pow_error_is_within_stated_bound() {
        for level in isas() {
            dispatch!(level, simd => assert_errors_are_small(simd));
        }
    }
}
