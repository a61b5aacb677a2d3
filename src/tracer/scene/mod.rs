//! The scene description. Units are in [the crate's conventions](crate#conventions).

mod ambience;
pub(crate) mod camera;
mod film;
mod light;
mod list;
mod material;
mod objects;
mod pattern;
pub(crate) mod ranges;
#[cfg(feature = "serde")]
pub(crate) mod serial;
mod softbox;
mod waves;

pub use ambience::Ambience;
pub use camera::{Camera, Raster};
pub use film::Film;
pub use light::{Light, Spot};
pub use list::{CapacityError, List};
pub use material::Material;
pub use objects::{Block, Plane, Shape, Sphere};
pub use pattern::Pattern;
pub use ranges::{MAX_LENGTH, MIN_LENGTH};
pub use softbox::Softbox;
pub use waves::Waves;

use crate::range_error::{Checked, Range, RangeError};
use crate::zero::Zero;
use glam::Vec3;
use ranges::{LENGTH, SHARE, THOUSAND, each};

/// The maximum number of spheres. The show uses up to 73.
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

/// The content of a frame. A [`Presentation`](crate::presentation::Presentation) adds marks,
/// mirrors and text.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Scene {
    /// The viewpoint.
    pub camera: Camera,
    /// The colour of the background at the horizon and below, 0 to 1e9 in each channel.
    pub background: Vec3,
    /// The zenith's colour minus `background`; the zenith's is 0 to 1e9 in each channel. A ray
    /// whose direction, of length 1, rises by y has the share `y (2 - y)` of it.
    pub sky: Vec3,
    /// The density of the haze in 1 / scene units, 0 to 1000. A surface at the distance t has the
    /// weight `1 / (1 + (haze t)^2)`; the background has the rest.
    pub haze: f32,
    /// The fall of the haze with height in 1 / scene units, 0 to 1000: at the height y above 0, its
    /// density is `haze / (1 + haze_fall y)^2`.
    pub haze_fall: f32,
    /// The share of the first light's colour that sky and haze scatter, 0 to 1. At an angle with
    /// the cosine c to the light's position, its weight is `c^8`, or 0 from 90 degrees on.
    pub scatter: f32,
    /// The factor on all light of the picture, 0 to 11.
    pub exposure: f32,
    /// The conversion of light to the picture's colours.
    pub film: Film,
    /// The ambient light on all surfaces, or from above, see [`Ambience`]; 0 to 1e9 in each
    /// channel.
    pub ambient: Vec3,
    /// The occlusion of ambient light, and the ambient light from below.
    pub ambience: Ambience,
    /// Whether untraced rays, see [`Quality::depth`](crate::Quality::depth), are black, as in the
    /// 2008 thesis; thin films then reflect nothing. This is a scene's look, not an error:
    /// exhaustive frames have such rays, too.
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

default!(Scene = Self { camera: Camera::STANDARD, exposure: 1.0, ..Self::ZERO });

zero! {
    Film = Film::PLAIN; Ambience = Ambience::UNIFORM; Waves = Waves::CALM; Shape = Shape::Box;
}

zero! {
    Camera { eye, look_at, up, field_of_view, min_aspect }
    Sphere { centre, radius, material }
    Plane { centre, half_x, half_z, material }
    Block { shape, centre, half, axes, material }
    Scene {
        camera, background, sky, haze, haze_fall, scatter, exposure, film, ambient, ambience,
        black_beyond, spheres, planes, water, blocks, lights, softboxes
    }
}

impl Scene {
    /// All zeros, so that a `static` scene takes no space in an executable file. It is invalid.
    #[doc(hidden)]
    pub const ZEROED: Self = Self::ZERO;

    /// Checks the ranges of all numbers.
    ///
    /// # Errors
    /// The first number out of range.
    pub fn validate(&self) -> Result<(), RangeError> {
        let zenith = self.background + self.sky;
        let sky = "-background to 1e9 - background";
        self.camera.check(Checked::one("camera"))?;
        Checked::one("background").field("", self.background, LENGTH)?;
        Checked::one("sky").rule("", self.sky, LENGTH.contains(zenith), sky)?;
        Checked::one("haze").field("", self.haze, THOUSAND)?;
        Checked::one("haze_fall").field("", self.haze_fall, THOUSAND)?;
        Checked::one("scatter").field("", self.scatter, SHARE)?;
        Checked::one("exposure").field("", self.exposure, Range(0.0, 11.0, "0 to 11"))?;
        self.film.check(Checked::one("film"))?;
        Checked::one("ambient").field("", self.ambient, LENGTH)?;
        self.ambience.check(Checked::one("ambience"))?;
        each("spheres", &self.spheres, Sphere::check)?;
        each("planes", &self.planes, Plane::check)?;
        self.water.check(Checked::one("water"))?;
        each("blocks", &self.blocks, Block::check)?;
        each("lights", &self.lights, Light::check)?;
        each("softboxes", &self.softboxes, Softbox::check)
    }

    pub(crate) fn solids(&self) -> usize {
        self.spheres.len() + self.blocks.len()
    }
}
