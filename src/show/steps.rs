//! Numbers of the show's tables: a byte each, in steps that the table names.
//!
//! Tables say what they mean, such as 1.25; what does not fit in a byte does not compile.

use glam::Vec3A;

/// Steps of a scene unit in places, of a radian in angles.
pub(super) const TENTHS: f32 = 10.0;
/// Steps of a scene unit in extents.
pub(super) const TWENTIETHS: f32 = 20.0;
/// Steps of 1 in colours and shares.
pub(super) const PERCENT: f32 = 100.0;

/// The steps that are nearest to a number.
pub(super) const fn steps(x: f32, to_one: f32) -> i8 {
    let half = if x < 0.0 { -0.5 } else { 0.5 };
    let count = x * to_one + half;
    assert!(count > -128.0 && count < 128.0, "a byte holds it");
    count as i8
}

/// A place.
pub(super) const fn at(x: f32, y: f32, z: f32) -> [i8; 3] {
    [steps(x, TENTHS), steps(y, TENTHS), steps(z, TENTHS)]
}

/// An extent.
pub(super) const fn half(x: f32, y: f32, z: f32) -> [i8; 3] {
    [
        steps(x, TWENTIETHS),
        steps(y, TWENTIETHS),
        steps(z, TWENTIETHS),
    ]
}

/// A colour.
pub(super) const fn rgb(red: f32, green: f32, blue: f32) -> [i8; 3] {
    [
        steps(red, PERCENT),
        steps(green, PERCENT),
        steps(blue, PERCENT),
    ]
}

/// The three numbers again, the very same ones that were said where they are whole steps: a quotient is rounded right.
#[inline(never)]
pub(super) fn vector(bytes: [i8; 3], to_one: f32) -> Vec3A {
    let [x, y, z] = bytes;
    Vec3A::new(f32::from(x), f32::from(y), f32::from(z)) / to_one
}

/// One number again.
#[inline(always)]
pub(super) fn number(byte: i8, to_one: f32) -> f32 {
    f32::from(byte) / to_one
}
