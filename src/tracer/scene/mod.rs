//! The scene description, and its presentation. Units are in [the crate's conventions](crate#conventions).

mod ambience;
mod block;
pub(crate) mod camera;
mod film;
mod light;
mod list;
mod material;
mod method;
mod overlay;
mod pattern;
mod presentation;
#[cfg(feature = "serde")]
mod serial;
mod softbox;
mod validate;
mod waves;

pub use ambience::Ambience;
pub use block::Block;
pub use camera::{Camera, Raster};
pub use film::Film;
pub use light::{Light, Spot};
pub use list::{CapacityError, List};
pub use material::Material;
pub use method::Method;
pub use overlay::Caption;
pub use pattern::Pattern;
pub use presentation::{Moment, Presentation};
pub use softbox::Softbox;
pub use validate::{MAX_LENGTH, MIN_LENGTH};
pub use waves::Waves;

use crate::range_error::{Checked, RangeError};
use glam::{Mat3, Vec3};
use validate::{EXTENT, POINT};

/// The maximum number of spheres. The show uses up to 71.
pub const MAX_SPHERES: usize = 320;
/// The maximum number of planes.
pub const MAX_PLANES: usize = 8;
/// The maximum number of blocks: boxes, cylinders and capsules.
pub const MAX_BLOCKS: usize = 128;
pub(crate) const MAX_SOLIDS: usize = MAX_SPHERES + MAX_BLOCKS;
/// The maximum number of lights.
pub const MAX_LIGHTS: usize = 4;

/// The maximum number of softboxes.
pub const MAX_SOFTBOXES: usize = 3;

/// The maximum number of captions. The show uses one at a time.
pub const MAX_CAPTIONS: usize = 10;
/// The maximum number of letters in a caption. The longest of the show has 32.
pub const MAX_LETTERS: usize = 32;

/// The content of a frame. A [`Presentation`] adds marks, mirrors and text.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Scene {
    /// The viewpoint.
    pub camera: Camera,
    /// The colour of the background at the horizon and below, 0 to 1e9 in each channel.
    pub background: Vec3,
    /// The zenith's colour minus `background`; the zenith's is 0 to 1e9 in each channel. A ray whose direction, of length 1, rises by y
    /// has the share `y (2 - y)` of it.
    pub sky: Vec3,
    /// The density of the haze in 1 / scene units, 0 to 1000. A surface at the distance t has the weight `1 / (1 + (haze t)^2)`; the
    /// background has the rest.
    pub haze: f32,
    /// The fall of the haze with height in 1 / scene units, 0 to 1000: at the height y above 0, its density is
    /// `haze / (1 + haze_fall y)^2`.
    pub haze_fall: f32,
    /// The share of the first light's colour that sky and haze scatter, 0 to 1. At an angle with the cosine c to the light's position,
    /// its weight is `c^8`, or 0 from 90 degrees on.
    pub scatter: f32,
    /// The factor on all light of the picture, 0 to 11.
    pub exposure: f32,
    /// The conversion of light to the picture's colours.
    pub film: Film,
    /// The ambient light on all surfaces, or from above, see [`Ambience`]; 0 to 1e9 in each channel.
    pub ambient: Vec3,
    /// The occlusion of ambient light, and the ambient light from below.
    pub ambience: Ambience,
    /// Whether rays beyond `depth` and `least_contribution` of the [`Quality`](crate::Quality), and softboxes, are black, as in the 2008
    /// thesis.
    pub black_beyond: bool,
    /// The spheres, in any order.
    pub spheres: List<Sphere, MAX_SPHERES>,
    /// The planes: horizontal rectangles.
    pub planes: List<Plane, MAX_PLANES>,
    /// The waves on the first plane.
    pub water: Waves,
    /// The boxes, cylinders and capsules.
    pub blocks: List<Block, MAX_BLOCKS>,
    /// The lights.
    pub lights: List<Light, MAX_LIGHTS>,
    /// The lights at infinity that only mirrors and glass show.
    pub softboxes: List<Softbox, MAX_SOFTBOXES>,
}

default!(Scene = Self::EMPTY);

impl Scene {
    /// Unused memory of lists is zero.
    const EMPTY: Self = {
        let material = Material { exponent: 0.0, index: 0.0, ..Material::BLACK };
        let block =
            Block { axes: Mat3::ZERO, ..Block::new(Shape::Box, Vec3::ZERO, Vec3::ZERO, material) };
        Self {
            camera: Camera::STANDARD,
            background: Vec3::ZERO,
            sky: Vec3::ZERO,
            haze: 0.0,
            haze_fall: 0.0,
            scatter: 0.0,
            exposure: 1.0,
            film: Film::PLAIN,
            ambient: Vec3::ZERO,
            ambience: Ambience::UNIFORM,
            black_beyond: false,
            spheres: List::over(Sphere::new(Vec3::ZERO, 0.0, material)),
            planes: List::over(Plane::new(Vec3::ZERO, 0.0, 0.0, material)),
            water: Waves::CALM,
            blocks: List::over(block),
            lights: List::over(Light::DARK),
            softboxes: List::over(Softbox::ZERO),
        }
    };

    /// All zeros, so that a `static` scene takes no space in an executable file. It is invalid.
    #[doc(hidden)]
    pub const ZEROED: Self = Self {
        camera: Camera { eye: Vec3::ZERO, up: Vec3::ZERO, field_of_view: 0.0, ..Camera::STANDARD },
        exposure: 0.0,
        ..Self::EMPTY
    };

    pub(crate) fn solids(&self) -> usize {
        self.spheres.len() + self.blocks.len()
    }
}

/// A sphere. Shadow rays treat it as hollow: a light wholly inside illuminates its inside, and the outside only through
/// [`Material::tint`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Sphere {
    /// The centre in scene units, coordinates -1e9 to 1e9.
    pub centre: Vec3,
    /// The radius in scene units, 1e-9 to 1e9.
    pub radius: f32,
    /// The surface.
    pub material: Material,
}

impl Sphere {
    /// Returns a sphere.
    #[must_use]
    pub const fn new(centre: Vec3, radius: f32, material: Material) -> Self {
        Self { centre, radius, material }
    }

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        of.field("centre", self.centre, POINT)?;
        of.field("radius", self.radius, EXTENT)?;
        self.material.check(of)
    }
}

/// A horizontal rectangle, visible from both sides. It casts a black shadow, whatever its `tint`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Plane {
    /// The centre in scene units, coordinates -1e9 to 1e9.
    pub centre: Vec3,
    /// Half the extent along x in scene units, 1e-9 to 1e9.
    pub half_x: f32,
    /// Half the extent along z, 1e-9 to 1e9.
    pub half_z: f32,
    /// The surface.
    pub material: Material,
}

impl Plane {
    /// Returns a rectangle.
    #[must_use]
    pub const fn new(centre: Vec3, half_x: f32, half_z: f32, material: Material) -> Self {
        Self { centre, half_x, half_z, material }
    }

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        of.field("centre", self.centre, POINT)?;
        of.field("half_x", self.half_x, EXTENT)?;
        of.field("half_z", self.half_z, EXTENT)?;
        self.material.check(of)
    }
}

/// The shape of a [`Block`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Shape {
    /// A box.
    #[default]
    Box,
    /// A cylinder along the block's own y axis, with flat ends.
    Cylinder,
    /// A cylinder along the block's own y axis with a half sphere at each end.
    Capsule,
}
