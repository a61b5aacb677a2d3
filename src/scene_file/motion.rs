//! Values that change with time.

use super::node::{Kind, Mistake, Node};
use serde::Deserialize;

/// The motion of a number or a vector.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Motion {
    /// The path of the value: `camera.eye`, `spheres[0].centre`, `materials["gold"].kr`.
    pub of: String,
    #[serde(default)]
    between: Between,
    #[serde(default)]
    repeat: bool,
    /// At least one, in the order of their times.
    #[serde(skip)]
    pub keys: Vec<Key>,
}

/// The interpolation between keys.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq)]
enum Between {
    #[default]
    Linear,
    /// Smoothstep.
    Smooth,
    /// Catmull-Rom: a key is passed at the mean speed between its neighbours.
    Spline,
    Hold,
}

/// A value at a time in seconds.
#[derive(Clone, Debug, PartialEq)]
pub struct Key {
    /// The offset in the text.
    at: usize,
    pub time: f32,
    numbers: Vec<f32>,
}

/// Returns the numbers of a scalar, a vector or a matrix.
fn numbers(node: &Node) -> Result<Vec<f32>, Mistake> {
    if node.kind == Kind::List {
        let all: Result<Vec<_>, _> = node.parts.iter().map(numbers).collect();
        return all.map(|all| all.concat());
    }
    f32::deserialize(node).map(|number| vec![number])
}

impl Motion {
    pub fn read(mut node: Node) -> Result<Self, Mistake> {
        let keys = node.take("keys");
        let mut motion = Self::deserialize(&node)?;
        for key in keys.iter().flat_map(|keys| &keys.parts) {
            let [time, value] = &key.parts[..] else {
                let message = format!("key length is {}; must be 2: time, value", key.parts.len());
                return Err(Mistake::new(key.at, message));
            };
            let at = key.at;
            let (time, numbers) = (f32::deserialize(time)?, numbers(value)?);
            let (before, count) = match motion.keys.last() {
                Some(last) => (last.time, last.numbers.len()),
                None => (f32::NEG_INFINITY, numbers.len()),
            };
            if !time.is_finite() {
                return Err(Mistake::new(at, format!("time is {time}; must be finite")));
            }
            if time <= before {
                let message = format!("time is {time}; must be above {before}");
                return Err(Mistake::new(at, message));
            }
            if numbers.len() != count {
                let message = format!("value length is {}; must be {count}", numbers.len());
                return Err(Mistake::new(at, message));
            }
            motion.keys.push(Key { at, time, numbers });
        }
        if motion.keys.is_empty() {
            return Err(Mistake::new(node.at, "keys are missing"));
        }
        Ok(motion)
    }

    /// Returns the current key's offset, and the numbers.
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
                // Constant outside the keys.
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
