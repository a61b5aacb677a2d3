//! Errors for numbers that are out of range.

use core::fmt;
use glam::Vec3;

/// The first number of a scene or a [`Quality`](crate::Quality) that is out of range, such as
/// `spheres[3].material.kd is 1.5; must be 0 to 1`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct RangeError {
    /// A scene's field, such as "spheres", or "quality".
    pub object: &'static str,
    /// The item's index, if the field is a list.
    pub index: Option<usize>,
    /// The field of the object, such as "material.kd"; empty for the object itself.
    pub field: &'static str,
    /// The value.
    pub found: Found,
    /// The valid values, such as "0 to 1".
    pub range: &'static str,
}

/// A value that is out of range.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Found {
    /// A number.
    Number(f32),
    /// A point, a direction or a colour.
    Vector(Vec3),
}

impl From<f32> for Found {
    fn from(number: f32) -> Self {
        Self::Number(number)
    }
}

impl From<Vec3> for Found {
    fn from(vector: Vec3) -> Self {
        Self::Vector(vector)
    }
}

impl fmt::Display for Found {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => number.fmt(f),
            Self::Vector(vector) => vector.fmt(f),
        }
    }
}

impl fmt::Display for RangeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.object)?;
        if let Some(index) = self.index {
            write!(f, "[{index}]")?;
        }
        let dot = if self.field.is_empty() { "" } else { "." };
        write!(f, "{dot}{} is {}; must be {}", self.field, self.found, self.range)
    }
}

impl core::error::Error for RangeError {}

/// The valid numbers, ends included, of a field or of a vector's components, and their text.
#[derive(Clone, Copy)]
pub(crate) struct Range(pub f32, pub f32, pub &'static str);

impl Range {
    pub fn contains(self, found: impl Into<Found>) -> bool {
        let is_inside = |number| (self.0..=self.1).contains(&number);
        match found.into() {
            Found::Number(number) => is_inside(number),
            Found::Vector(vector) => vector.to_array().into_iter().all(is_inside),
        }
    }
}

#[derive(Clone, Copy)]
pub(crate) struct Checked {
    pub object: &'static str,
    pub index: Option<usize>,
}

impl Checked {
    pub fn one(object: &'static str) -> Self {
        Self { object, index: None }
    }

    /// An empty name means the object itself.
    pub fn field(
        self,
        field: &'static str,
        found: impl Into<Found>,
        range: Range,
    ) -> Result<(), RangeError> {
        let found = found.into();
        self.rule(field, found, range.contains(found), range.2)
    }

    pub fn rule(
        self,
        field: &'static str,
        found: impl Into<Found>,
        is_obeyed: bool,
        range: &'static str,
    ) -> Result<(), RangeError> {
        if is_obeyed {
            return Ok(());
        }
        let (Self { object, index }, found) = (self, found.into());
        Err(RangeError { object, index, field, found, range })
    }
}
