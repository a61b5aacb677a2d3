//! Values between keys: times in seconds, in order, each with the value that it has then. Before the first key and after the last
//! one a value keeps still.

use std::ops::{Add, Mul, Sub};

/// What can be interpolated.
pub trait Value: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<f32, Output = Self> {}

impl<T: Copy + Add<Output = T> + Sub<Output = T> + Mul<f32, Output = T>> Value for T {}

/// At a constant speed from key to key.
pub fn linear<T: Value>(keys: &[(f32, T)], time: f32) -> T {
    let (a, b, share) = around(keys, time);
    if share > 0.0 { a + (b - a) * share } else { a }
}

/// Leaving each key slowly, and coming slowly to the next, by Hermite's smooth step.
pub fn smooth<T: Value>(keys: &[(f32, T)], time: f32) -> T {
    let (a, b, share) = around(keys, time);
    let share = share * share * (3.0 - 2.0 * share);
    if share > 0.0 { a + (b - a) * share } else { a }
}

/// As the last key says, up to the next.
pub fn hold<T: Value>(keys: &[(f32, T)], time: f32) -> T {
    around(keys, time).0
}

/// Through the keys without a corner, by a Catmull-Rom spline: it passes a key at the mean speed between its neighbours.
pub fn spline<T: Value>(keys: &[(f32, T)], time: f32) -> T {
    let (_, _, s) = around(keys, time);
    let next = keys.partition_point(|(at, _)| *at <= time);
    let key = |i: usize| keys[i.min(keys.len() - 1)];
    let (start, end) = (key(next.saturating_sub(1)), key(next));
    if s <= 0.0 {
        return start.1;
    }
    let slope = |a: (f32, T), b: (f32, T)| (b.1 - a.1) * ((end.0 - start.0) / (b.0 - a.0));
    let leaving = slope(key(next.saturating_sub(2)), end);
    let coming = slope(start, key(next + 1));
    let (s2, s3) = (s * s, s * s * s);
    start.1 * (2.0 * s3 - 3.0 * s2 + 1.0)
        + end.1 * (3.0 * s2 - 2.0 * s3)
        + leaving * (s3 - 2.0 * s2 + s)
        + coming * (s3 - s2)
}

/// The values of the keys before and after a time, and how far it is from the one to the other, 0 to 1.
fn around<T: Value>(keys: &[(f32, T)], time: f32) -> (T, T, f32) {
    let next = keys.partition_point(|(at, _)| *at <= time);
    let (from, a) = keys[next.saturating_sub(1)];
    let (to, b) = keys[next.min(keys.len() - 1)];
    let share = if next > 0 && to > from {
        (time - from) / (to - from)
    } else {
        0.0
    };
    (a, b, share)
}
