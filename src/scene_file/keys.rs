//! Values between keys: times in seconds, in order, each with the value that it has then. Before the first key and after the last
//! one a value keeps still.

use std::ops::{Add, Mul, Sub};

/// A value that can be interpolated.
pub trait Value: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<f32, Output = Self> {}

impl<T: Copy + Add<Output = T> + Sub<Output = T> + Mul<f32, Output = T>> Value for T {}

/// At a constant speed from key to key.
pub fn linear<T: Value>(keys: &[(f32, T)], time: f32) -> T {
    let (i, share) = position(keys, time);
    blend(keys, i, share)
}

/// Leaving each key slowly, and coming slowly to the next, by Hermite's smooth step.
pub fn smooth<T: Value>(keys: &[(f32, T)], time: f32) -> T {
    let (i, share) = position(keys, time);
    blend(keys, i, share * share * (3.0 - 2.0 * share))
}

/// As the last key says, up to the next.
pub fn hold<T: Value>(keys: &[(f32, T)], time: f32) -> T {
    keys[position(keys, time).0].1
}

/// Through the keys without a corner, by a Catmull-Rom spline: it passes a key at the mean speed between its neighbours.
pub fn spline<T: Value>(keys: &[(f32, T)], time: f32) -> T {
    let (i, s) = position(keys, time);
    let start = keys[i];
    if s <= 0.0 {
        return start.1;
    }
    let end = keys[i + 1];
    let slope = |a: (f32, T), b: (f32, T)| (b.1 - a.1) * ((end.0 - start.0) / (b.0 - a.0));
    let leaving = slope(keys[i.saturating_sub(1)], end);
    let coming = slope(start, keys[(i + 2).min(keys.len() - 1)]);
    let (s2, s3) = (s * s, s * s * s);
    start.1 * (2.0 * s3 - 3.0 * s2 + 1.0)
        + end.1 * (3.0 * s2 - 2.0 * s3)
        + leaving * (s3 - 2.0 * s2 + s)
        + coming * (s3 - s2)
}

/// The index of the last key up to a time, and how far the time is from this key to the next, 0 to 1. Before the first key and after
/// the last one that is 0.
fn position<T>(keys: &[(f32, T)], time: f32) -> (usize, f32) {
    let next = keys.partition_point(|(at, _)| *at <= time);
    let i = next.saturating_sub(1);
    if next == 0 || next == keys.len() {
        return (i, 0.0);
    }
    let (from, to) = (keys[i].0, keys[next].0);
    (i, (time - from) / (to - from))
}

/// The value a share of the way from a key to the next. At the key it is the key's own to the bit, -0 included.
fn blend<T: Value>(keys: &[(f32, T)], i: usize, share: f32) -> T {
    let start = keys[i].1;
    if share > 0.0 {
        start + (keys[i + 1].1 - start) * share
    } else {
        start
    }
}
