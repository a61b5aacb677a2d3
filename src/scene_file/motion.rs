//! Numbers of a scene that change with time.

use super::{earlier, keys};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::ops::{Add, Mul, Sub};

/// How one number of the scene, or one vector, changes with time.
#[derive(Clone, Debug, Serialize, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Motion {
    /// The value that changes, by its path in the file: `camera.eye`, `spheres[0].centre`, `materials["gold"].kr`.
    #[serde(deserialize_with = "earlier::read_path")]
    pub of: String,
    /// The course of values between two keys.
    #[serde(default)]
    pub between: Between,
    /// Whether it starts again after the last key.
    #[serde(default)]
    pub repeat: bool,
    /// Times in seconds, in order, each with the value that it has then.
    pub keys: Vec<(f32, Numbers)>,
}

/// How a motion goes from key to key; see the functions of the same names in [`keys`].
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize, PartialEq)]
pub enum Between {
    #[default]
    Linear,
    Smooth,
    Spline,
    Hold,
}

impl Motion {
    /// The value at a time. There has to be a key.
    pub fn at(&self, time: f32) -> Numbers {
        let time = self.period().map_or(time, |period| time.rem_euclid(period));
        let value = match self.between {
            Between::Linear => keys::linear,
            Between::Smooth => keys::smooth,
            Between::Spline => keys::spline,
            Between::Hold => keys::hold,
        };
        value(&self.keys, time)
    }

    /// After how many seconds it starts again: the time of the last key, if it repeats and that is after 0.
    pub fn period(&self) -> Option<f32> {
        let (end, _) = self.keys.last()?;
        (self.repeat && *end > 0.0).then_some(*end)
    }
}

/// A number, or several, such as those of a point.
#[derive(Clone, Copy, Debug, Serialize, Deserialize, PartialEq)]
#[serde(untagged)]
pub enum Numbers {
    One(f32),
    Three([f32; 3]),
    /// The axes of a block.
    Nine([[f32; 3]; 3]),
}

impl Numbers {
    /// The numbers of a value in a scene's tree; `None` if it is something else.
    pub fn of(value: &Value) -> Option<Self> {
        serde_json::from_value(value.clone()).ok()
    }

    /// Whether both have as many numbers.
    pub fn fits(self, other: Self) -> bool {
        std::mem::discriminant(&self) == std::mem::discriminant(&other)
    }

    /// Whether they are neither infinite nor NaN.
    pub fn are_finite(self) -> bool {
        match self {
            Self::One(number) => number.is_finite(),
            Self::Three(numbers) => numbers.iter().all(|number| number.is_finite()),
            Self::Nine(axes) => axes.as_flattened().iter().all(|number| number.is_finite()),
        }
    }

    /// Applies a function to each number and its counterpart.
    fn combine(self, other: Self, f: impl Fn(f32, f32) -> f32) -> Self {
        let three = |a: [f32; 3], b: [f32; 3]| [0, 1, 2].map(|i| f(a[i], b[i]));
        match (self, other) {
            (Self::One(a), Self::One(b)) => Self::One(f(a, b)),
            (Self::Three(a), Self::Three(b)) => Self::Three(three(a, b)),
            (Self::Nine(a), Self::Nine(b)) => Self::Nine([0, 1, 2].map(|i| three(a[i], b[i]))),
            _ => self,
        }
    }
}

impl Add for Numbers {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.combine(other, |a, b| a + b)
    }
}

impl Sub for Numbers {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self.combine(other, |a, b| a - b)
    }
}

impl Mul<f32> for Numbers {
    type Output = Self;

    fn mul(self, factor: f32) -> Self {
        self.combine(self, |a, _| a * factor)
    }
}
