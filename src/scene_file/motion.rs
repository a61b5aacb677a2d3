//! Numbers of a scene that change with time.

use super::node::{Fault, Kind, Node};
use serde::Deserialize;

/// The motion of a number of the scene, or of a vector.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Motion {
    /// The path of the value in the file: `camera.eye`, `spheres[0].centre`, `materials["gold"].kr`.
    pub of: String,
    #[serde(default)]
    between: Between,
    /// Whether it starts again after the last key.
    #[serde(default)]
    repeat: bool,
    /// In the order of their times; one at least.
    #[serde(skip)]
    pub keys: Vec<Key>,
}

/// The course of a value from key to key.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq)]
enum Between {
    /// At a constant speed.
    #[default]
    Linear,
    /// Slow at each key, by Hermite's smooth step.
    Smooth,
    /// Without a corner, by a Catmull-Rom spline: it passes a key at the mean speed between its neighbours.
    Spline,
    /// The value of the last key.
    Hold,
}

/// A time in seconds, and the value at that time.
#[derive(Clone, Debug, PartialEq)]
pub struct Key {
    /// The byte of the text at which it begins.
    at: usize,
    pub time: f32,
    numbers: Vec<f32>,
}

/// Returns a number, or all numbers of a vector or a matrix.
fn numbers(node: &Node) -> Result<Vec<f32>, Fault> {
    if node.kind == Kind::List {
        let all: Result<Vec<_>, _> = node.parts.iter().map(numbers).collect();
        return all.map(|all| all.concat());
    }
    f32::deserialize(node).map(|number| vec![number])
}

impl Motion {
    /// Reads a motion.
    ///
    /// # Errors
    /// The first mistake in it.
    pub fn read(mut node: Node) -> Result<Self, Fault> {
        let keys = node.take("keys");
        let mut motion = Self::deserialize(&node)?;
        for key in keys.iter().flat_map(|keys| &keys.parts) {
            let [time, value] = &key.parts[..] else {
                return Err(Fault::new(key.at, "key must be (seconds, value)"));
            };
            let at = key.at;
            let (time, numbers) = (f32::deserialize(time)?, numbers(value)?);
            let (before, count) = match motion.keys.last() {
                Some(last) => (last.time, last.numbers.len()),
                None => (f32::MIN, numbers.len()),
            };
            if !(time > before && time.is_finite()) {
                return Err(Fault::new(
                    at,
                    format!("time is {time}, must be above {before}"),
                ));
            }
            if numbers.len() != count {
                return Err(Fault::new(at, format!("key must have {count} numbers")));
            }
            motion.keys.push(Key { at, time, numbers });
        }
        if motion.keys.is_empty() {
            return Err(Fault::new(node.at, "motion must have a key"));
        }
        Ok(motion)
    }

    /// Returns the numbers at a time in seconds, and the place of their key in the text.
    pub fn at(&self, time: f32) -> (usize, Vec<f32>) {
        let (keys, last) = (&self.keys, self.keys.len() - 1);
        let time = match self.repeat {
            true => time.rem_euclid(keys[last].time),
            false => time,
        };
        let next = keys.partition_point(|key| key.time <= time);
        let (i, next) = (next.saturating_sub(1), next.min(last));
        let (start, end) = (&keys[i], &keys[next]);
        let (before, after) = (&keys[i.saturating_sub(1)], &keys[last.min(next + 1)]);
        let length = end.time - start.time;
        let s = (time - start.time) / length;
        let number = |n: usize| {
            let [a, b, c, d] = [before, start, end, after].map(|key| key.numbers[n]);
            match self.between {
                // Before the first key and after the last one it keeps still.
                _ if i == next => b,
                Between::Hold => b,
                Between::Linear => b + (c - b) * s,
                Between::Smooth => b + (c - b) * (s * s * (3.0 - 2.0 * s)),
                Between::Spline => {
                    let leaving = (c - a) * (length / (end.time - before.time));
                    let coming = (d - b) * (length / (after.time - start.time));
                    let (s2, s3) = (s * s, s * s * s);
                    b * (2.0 * s3 - 3.0 * s2 + 1.0)
                        + c * (3.0 * s2 - 2.0 * s3)
                        + leaving * (s3 - 2.0 * s2 + s)
                        + coming * (s3 - s2)
                }
            }
        };
        (start.at, (0..start.numbers.len()).map(number).collect())
    }
}
