//! Values that change with time.

use super::node::{Kind, Mistake, Node};
use serde::Deserialize;

#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Motion {
    /// The path of the value: `camera.eye`, `spheres[0].centre`, `materials["gold"].kr`.
    pub of: String,
    #[serde(default)]
    between: Between,
    #[serde(default)]
    repeat: bool,
    #[serde(skip)]
    pub index: usize,
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
    at: usize,
    pub time: f32,
    numbers: Vec<f32>,
}

/// The largest time of a key, in seconds. Differences of larger ones would lose whole seconds.
const MAX_TIME: f32 = 1e6;
/// The most checked repetitions: motions with different periods meet in ever new ways.
const MAX_CYCLES: u16 = 500;

/// Returns the numbers of a scalar, a vector or a matrix.
fn numbers(node: &Node) -> Result<Vec<f32>, Mistake> {
    if node.kind == Kind::List {
        let all: Result<Vec<_>, _> = node.parts.iter().map(numbers).collect();
        return all.map(|all| all.concat());
    }
    f32::deserialize(node).map(|number| vec![number])
}

impl Motion {
    pub fn read((index, mut node): (usize, Node)) -> Result<Self, Mistake> {
        let keys = node.take("keys");
        let mut motion = Self::deserialize(&node)?;
        motion.index = index;
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
            let message = if !(-MAX_TIME..=MAX_TIME).contains(&time) {
                format!("time is {time}; must be -1e6 to 1e6")
            } else if time <= before {
                format!("time is {time}; must be above {before}")
            } else if let Some(number) = numbers.iter().find(|number| !number.is_finite()) {
                format!("value is {number}; must be finite")
            } else if numbers.len() != count {
                format!("value length is {}; must be {count}", numbers.len())
            } else {
                motion.keys.push(Key { at, time, numbers });
                continue;
            };
            return Err(Mistake::new(at, message));
        }
        if motion.keys.is_empty() {
            return Err(Mistake::new(node.at, "keys are missing"));
        }
        Ok(motion)
    }

    pub fn at(&self, time: f32) -> (usize, Vec<f32>) {
        let (keys, last) = (&self.keys, self.keys.len() - 1);
        let time = match self.repeat {
            true => time.rem_euclid(self.end()),
            false => time,
        };
        let next = keys.partition_point(|key| key.time <= time);
        let (i, next) = (next.saturating_sub(1), next.min(last));
        let (start, end) = (&keys[i], &keys[next]);
        let s = (time - start.time) / (end.time - start.time);
        let number = |n: usize| {
            let (b, c) = (start.numbers[n], end.numbers[n]);
            // Rounding must not leave the range of the keys.
            let inside = |value: f32| value.max(b.min(c)).min(b.max(c));
            match self.between {
                // Constant outside the keys.
                _ if i == next => b,
                Between::Hold => b,
                Between::Linear => inside(b + (c - b) * s),
                Between::Smooth => inside(b + (c - b) * (s * s * (3.0 - 2.0 * s))),
                Between::Spline => {
                    let [leaving, coming] = self.slopes(i, n);
                    let (s2, s3) = (s * s, s * s * s);
                    let value = b * (2.0 * s3 - 3.0 * s2 + 1.0)
                        + c * (3.0 * s2 - 2.0 * s3)
                        + leaving * (s3 - 2.0 * s2 + s)
                        + coming * (s3 - s2);
                    match self.extremes(i, n).next() {
                        Some(_) => value,
                        None => inside(value),
                    }
                }
            }
        };
        (start.at, (0..start.numbers.len()).map(number).collect())
    }

    /// Returns a spline's slopes after the key `i` and before the next, times the seconds between
    /// them.
    fn slopes(&self, i: usize, n: usize) -> [f32; 2] {
        let last = self.keys.len() - 1;
        let places = [i.saturating_sub(1), i, i + 1, last.min(i + 2)];
        let [before, start, end, after] = places.map(|i| self.keys[i].time);
        let [a, b, c, d] = places.map(|i| self.keys[i].numbers[n]);
        let length = end - start;
        [(c - a) * (length / (end - before)), (d - b) * (length / (after - start))]
    }

    /// Returns a spline's extremes between the key `i` and the next, 0 to 1: the roots of its
    /// derivative.
    fn extremes(&self, i: usize, n: usize) -> impl Iterator<Item = f32> {
        let [b, c] = [i, i + 1].map(|i| f64::from(self.keys[i].numbers[n]));
        let [leaving, coming] = self.slopes(i, n).map(f64::from);
        let square = 6.0 * (b - c) + 3.0 * (leaving + coming);
        let linear = -6.0 * (b - c) - 4.0 * leaving - 2.0 * coming;
        let root = (linear * linear - 4.0 * square * leaving).sqrt();
        let q = -0.5 * (linear + root.copysign(linear));
        let roots = [q / square, leaving / q].map(|s| s as f32);
        roots.into_iter().filter(|&s| 0.0 < s && s < 1.0)
    }

    pub fn times(&self, until: f32) -> Vec<f32> {
        let mut times: Vec<f32> = self.keys.iter().map(|key| key.time).collect();
        let period = times[times.len() - 1];
        if self.between == Between::Spline {
            for (i, pair) in self.keys.windows(2).enumerate() {
                let (start, length) = (pair[0].time, pair[1].time - pair[0].time);
                for n in 0..pair[0].numbers.len() {
                    times.extend(self.extremes(i, n).map(|s| start + s * length));
                }
            }
        }
        if self.repeat && period > 0.0 {
            times.retain(|&time| time >= 0.0);
            let once = times.clone();
            let starts = (1..MAX_CYCLES).map(|cycle| f32::from(cycle) * period);
            for start in starts.take_while(|&start| start < until) {
                times.extend(once.iter().map(|time| start + time));
            }
        }
        times
    }

    pub fn frozen(&self) -> Self {
        let (at, numbers) = self.at(0.0);
        let time = 0.0;
        Self { of: self.of.clone(), keys: vec![Key { at, time, numbers }], ..*self }
    }

    pub fn end(&self) -> f32 {
        self.keys.last().map_or(0.0, |key| key.time)
    }
}
