//! A flaw of a scene or a quality: which number, what it is, and what it may be.

use core::fmt;
use glam::{Vec3, Vec3A};

/// The first number of a [`Scene`](crate::scene::Scene) or a [`Quality`](crate::Quality) that is out of its range.
///
/// It is displayed by the name that the number has in a program: `spheres[3].material.kd is 1.5, and takes 0 to 1`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Flaw {
    /// The field of the scene that has it, such as "spheres", or "quality".
    pub object: &'static str,
    /// Which item it is where the field is a list.
    pub index: Option<usize>,
    /// The field inside of the object, such as "material.kd"; empty where the object itself is the number.
    pub field: &'static str,
    /// The value that is there now.
    pub found: Found,
    /// The values that may be there.
    pub takes: &'static str,
}

/// A value that is out of its range.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Found {
    /// A number.
    Number(f32),
    /// A whole number.
    Count(usize),
    /// A point, a direction or a colour.
    Vector(Vec3),
}

impl From<f32> for Found {
    fn from(number: f32) -> Self {
        Self::Number(number)
    }
}

impl From<usize> for Found {
    fn from(count: usize) -> Self {
        Self::Count(count)
    }
}

impl From<Vec3A> for Found {
    fn from(vector: Vec3A) -> Self {
        Self::Vector(vector.into())
    }
}

impl fmt::Display for Found {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => write!(f, "{number}"),
            Self::Count(count) => write!(f, "{count}"),
            Self::Vector(vector) => write!(f, "{vector}"),
        }
    }
}

impl fmt::Display for Flaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.object)?;
        if let Some(index) = self.index {
            write!(f, "[{index}]")?;
        }
        if !self.field.is_empty() {
            write!(f, ".{}", self.field)?;
        }
        write!(f, " is {}, and takes {}", self.found, self.takes)
    }
}

impl core::error::Error for Flaw {}

/// The thing that is checked: a scene, one of its fields, or an item of one that is a list.
#[derive(Clone, Copy)]
pub(crate) struct Checked {
    pub object: &'static str,
    pub index: Option<usize>,
}

impl Checked {
    /// The scene itself, which has no name.
    pub const SCENE: Self = Self {
        object: "",
        index: None,
    };

    /// Itself, or a field of the scene.
    pub fn or_one(self, field: &'static str) -> Self {
        if self.object.is_empty() {
            Self::one(field)
        } else {
            self
        }
    }

    /// A thing that stands alone.
    pub fn one(object: &'static str) -> Self {
        Self {
            object,
            index: None,
        }
    }

    /// An item of a list.
    pub fn item(object: &'static str, index: usize) -> Self {
        Self {
            object,
            index: Some(index),
        }
    }

    /// Finds a flaw in a field unless it is in its range.
    pub fn field(
        self,
        field: &'static str,
        found: impl Into<Found>,
        takes: &'static str,
        is_in_range: bool,
    ) -> Result<(), Flaw> {
        if is_in_range {
            return Ok(());
        }
        let is_number = self.object.is_empty();
        Err(Flaw {
            object: if is_number { field } else { self.object },
            index: self.index,
            field: if is_number { "" } else { field },
            found: found.into(),
            takes,
        })
    }
}
