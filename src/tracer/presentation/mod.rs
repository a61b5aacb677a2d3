//! The presentation of a scene: mirrored sectors, an overlay of the method, and captions.

mod caption;
mod method;

pub use caption::{Caption, MAX_LETTERS};
pub use method::Method;

use crate::range_error::{Checked, Range, RangeError};
use crate::scene::ranges::each;
use crate::scene::{List, Scene};
use crate::zero::Zero;

/// The maximum number of captions. The show uses one at a time.
pub const MAX_CAPTIONS: usize = 10;

/// The presentation of a scene in a [`Frame`](crate::Frame): mirrored sectors, marks of the
/// rendering method, and text.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Presentation {
    /// The number of sectors of a kaleidoscope, 1 to 8, rounded down to a power of two: 1 for none;
    /// 2 mirrors the picture left and right; 4 also up and down; 8 also along diagonals.
    ///
    /// The centre is in the middle, at 46 % of the height, closer to the middle where
    /// [`Camera::min_aspect`](crate::scene::Camera::min_aspect) widens the view. The picture moves
    /// by up to 8 pixels: the centre is the corner of a square. Only one sector is traced (of 8 the
    /// one to the lower right). Captions are not mirrored.
    pub sectors: f32,
    /// The overlay that explains the rendering method.
    pub method: Method,
    /// Text over the picture.
    pub captions: List<Caption, MAX_CAPTIONS>,
}

default!(Presentation = Self::PLAIN);

impl Presentation {
    /// The picture of the scene only.
    pub const PLAIN: Self = Self { sectors: 1.0, method: Method::PLAIN, captions: Zero::ZERO };

    /// All zeros, like [`Scene::ZEROED`]. It is invalid.
    #[doc(hidden)]
    pub const ZEROED: Self =
        Self { sectors: 0.0, method: Method { picture: 0.0, ..Method::PLAIN }, ..Self::PLAIN };

    /// Checks the ranges of all numbers.
    ///
    /// # Errors
    /// The first number out of range.
    pub fn validate(&self) -> Result<(), RangeError> {
        Checked::one("sectors").field("", self.sectors, Range(1.0, 8.0, "1 to 8"))?;
        self.method.check(Checked::one("method"))?;
        each("captions", &self.captions, Caption::check)
    }
}

/// A scene and its presentation.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Moment {
    /// The content of the frame.
    pub scene: Scene,
    /// The presentation of the content.
    pub presentation: Presentation,
}

impl From<Scene> for Moment {
    fn from(scene: Scene) -> Self {
        Self { scene, ..Self::default() }
    }
}

impl Moment {
    /// All zeros, like [`Scene::ZEROED`].
    #[doc(hidden)]
    pub const ZEROED: Self = Self { scene: Scene::ZEROED, presentation: Presentation::ZEROED };

    /// Checks the ranges of all numbers.
    ///
    /// # Errors
    /// The first number out of range.
    pub fn validate(&self) -> Result<(), RangeError> {
        self.scene.validate()?;
        self.presentation.validate()
    }
}
