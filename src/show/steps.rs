//! Numbers of the show's tables: a byte each, in steps that the table names.
//!
//! Tables say what they mean, such as 1.25; what does not fit in a byte does not compile.

/// Steps of a scene unit in places and extents, of a radian in angles.
pub(super) const TENTHS: f32 = 10.0;
/// Steps of 1 in colours and shares.
pub(super) const PERCENT: f32 = 100.0;

/// Numbers of the longest row.
pub(super) const LONGEST: usize = 16;

/// The steps that are nearest to each number.
pub(super) const fn steps<const N: usize>(numbers: [f32; N], to_one: f32) -> [i8; N] {
    let mut bytes = [0; N];
    let mut i = 0;
    while i < N {
        let half = if numbers[i] < 0.0 { -0.5 } else { 0.5 };
        let count = numbers[i] * to_one + half;
        assert!(count > -128.0 && count < 128.0, "a byte holds it");
        bytes[i] = count as i8;
        i += 1;
    }
    bytes
}

/// The numbers of a row again, the very same ones that were said where they are whole steps: a quotient is rounded right.
#[inline(never)]
pub(super) fn numbers(row: &[i8], to_one: f32) -> [f32; LONGEST] {
    let mut numbers = [0.0; LONGEST];
    for (number, &byte) in numbers.iter_mut().zip(row) {
        *number = f32::from(byte) / to_one;
    }
    numbers
}
