//! What is drawn: a camera, a few primitives with their materials, and lights.
//!
//! Right-handed coordinates, y up; lengths in scene units; colours linear RGB, 0 to 1. [`Scene::validate`] says whether
//! all numbers are in their ranges.

mod block;
pub(crate) mod camera;
mod caption;
mod list;
mod method;
mod pattern;
mod validate;

pub use block::Block;
pub use camera::Camera;
pub use caption::{Caption, MAX_LETTERS};
use glam::{Mat3A, Vec3A};
pub use list::List;
pub use method::Method;
pub use pattern::Pattern;
pub use validate::{Flaw, MAX_LENGTH, MIN_LENGTH};

/// Spheres a scene can hold: the largest scene in use, a field of 256, with room to grow.
pub const MAX_SPHERES: usize = 320;
/// Planes a scene can hold.
pub const MAX_PLANES: usize = 8;
/// Boxes and cylinders a scene can hold.
pub const MAX_BLOCKS: usize = 64;
/// Spheres, boxes and cylinders.
pub(crate) const MAX_SOLIDS: usize = MAX_SPHERES + MAX_BLOCKS;
/// Lights a scene can hold.
pub const MAX_LIGHTS: usize = 4;

/// Captions a scene can hold: as many as the show has.
pub const MAX_CAPTIONS: usize = 10;

/// Everything one frame shows.
#[derive(Clone, Copy, Debug, Default)]
pub struct Scene {
    /// Where the picture is taken from.
    pub camera: Camera,
    /// The background at the horizon and below.
    pub background: Vec3A,
    /// Added to the background at the zenith, weighted by `y (2 - y)` where a ray of length 1 rises by y.
    pub sky: Vec3A,
    /// Haze, in 1 / scene units: after a way of length t a share of `1 - 1 / (1 + (haze t)^2)` of the light that surfaces
    /// send is lost to what lies behind them. 0 is clear.
    pub haze: f32,
    /// How far the picture is faded: 0 as it is, 1 black, below 0 brighter.
    pub fade: f32,
    /// Light that reaches every surface alike.
    pub ambient: Vec3A,
    /// How the picture shows its own making.
    pub method: Method,
    /// Spheres, in no particular order.
    pub spheres: List<Sphere, MAX_SPHERES>,
    /// Horizontal bounded planes.
    pub planes: List<Plane, MAX_PLANES>,
    /// Boxes and cylinders.
    pub blocks: List<Block, MAX_BLOCKS>,
    /// Lights.
    pub lights: List<Light, MAX_LIGHTS>,
    /// What is written over the picture.
    pub captions: List<Caption, MAX_CAPTIONS>,
}

impl Scene {
    /// All zeros: memory for a scene, which takes no room in a program's file. It is not a valid one.
    pub const ZEROED: Self = {
        let material = Material {
            exponent: 0.0,
            index: 0.0,
            ..Material::BLACK
        };
        Self {
            camera: Camera {
                eye: Vec3A::ZERO,
                look_at: Vec3A::ZERO,
                up: Vec3A::ZERO,
                field_of_view: 0.0,
            },
            background: Vec3A::ZERO,
            sky: Vec3A::ZERO,
            haze: 0.0,
            fade: 0.0,
            ambient: Vec3A::ZERO,
            method: Method {
                points: 0.0,
                squares: 0.0,
                picture: 0.0,
            },
            spheres: List::over(Sphere {
                centre: Vec3A::ZERO,
                radius: 0.0,
                material,
            }),
            planes: List::over(Plane {
                centre: Vec3A::ZERO,
                half_x: 0.0,
                half_z: 0.0,
                material,
            }),
            blocks: List::over(Block {
                centre: Vec3A::ZERO,
                half: Vec3A::ZERO,
                axes: Mat3A::ZERO,
                round: false,
                material,
            }),
            lights: List::over(Light::DARK),
            captions: List::over(Caption::NONE),
        }
    };

    /// Spheres, boxes and cylinders.
    pub(crate) fn solids(&self) -> usize {
        self.spheres.len() + self.blocks.len()
    }
}

/// How a surface answers light, by Phong's model.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Material {
    /// Colour of the surface; highlights take the light's colour instead.
    pub colour: Vec3A,
    /// Diffuse coefficient, 0 to 1.
    pub kd: f32,
    /// Specular coefficient, 0 to 1.
    pub ks: f32,
    /// Exponent of the highlight, 1 to 1000; larger is smaller and sharper.
    pub exponent: f32,
    /// Share of the reflected ray, 0 to 1.
    pub kr: f32,
    /// Share of the transmitted ray, 0 to 1; above 0 the surface is transparent.
    pub kt: f32,
    /// Refractive index of the inside against the outside, 0.1 to 10; used where `kt` is above 0.
    pub index: f32,
    /// How the surface lets the light of lamps with a size pass, as a colour; black throws a full shadow.
    pub tint: Vec3A,
    /// What varies its colour.
    pub pattern: Pattern,
}

impl Material {
    /// Black.
    pub const BLACK: Self = Self {
        colour: Vec3A::ZERO,
        kd: 0.0,
        ks: 0.0,
        exponent: 1.0,
        kr: 0.0,
        kt: 0.0,
        index: 1.0,
        tint: Vec3A::ZERO,
        pattern: Pattern::NONE,
    };
}

/// A sphere.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sphere {
    /// Centre.
    pub centre: Vec3A,
    /// Radius, [`MIN_LENGTH`] to [`MAX_LENGTH`].
    pub radius: f32,
    /// Surface.
    pub material: Material,
}

/// A horizontal rectangle, seen from above and from below.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Plane {
    /// Middle of the rectangle.
    pub centre: Vec3A,
    /// Half its extent along x, [`MIN_LENGTH`] to [`MAX_LENGTH`].
    pub half_x: f32,
    /// Half its extent along z, [`MIN_LENGTH`] to [`MAX_LENGTH`].
    pub half_z: f32,
    /// Surface.
    pub material: Material,
}

/// A light without attenuation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Light {
    /// Where the light comes from.
    pub position: Vec3A,
    /// Colour times brightness.
    pub colour: Vec3A,
    /// Radius of the sphere it is drawn as, which casts no shadow, [`MIN_LENGTH`] to [`MAX_LENGTH`]; 0 is not seen.
    pub radius: f32,
    /// Its rays are as good as parallel: it stands [`Light::FAR`] times as far away as `position` says, as large as it
    /// looks from there.
    pub parallel: bool,
    /// Its diameter as shadows see it: spheres throw penumbras, and tinted ones colour theirs. 0 is a point, whose
    /// shadows are hard and full.
    pub size: f32,
    /// What narrows it to a cone.
    pub spot: Option<Spot>,
}

impl Light {
    /// Factor on the distance of a light with parallel rays: its rays are off by at most 0.001 radians across a scene as
    /// wide as its distance.
    pub const FAR: f32 = 1000.0;

    /// A dark point.
    pub const DARK: Self = Self {
        position: Vec3A::ZERO,
        colour: Vec3A::ZERO,
        radius: 0.0,
        parallel: false,
        size: 0.0,
        spot: None,
    };

    /// Where it stands.
    pub(crate) fn place(&self) -> Vec3A {
        if self.parallel {
            self.position * Self::FAR
        } else {
            self.position
        }
    }

    /// Its diameter where it stands.
    pub(crate) fn diameter(&self) -> f32 {
        if self.parallel {
            self.size * Self::FAR
        } else {
            self.size
        }
    }

    /// The widest that a penumbra is taken to be at what throws it: for parallel rays that is reached four times as far
    /// away as `position` says.
    pub(crate) fn max_penumbra(&self) -> f32 {
        if self.parallel {
            4.0 * self.size
        } else {
            self.size
        }
    }

    /// Whether it is no more than a point.
    pub(crate) fn is_plain(&self) -> bool {
        self.size == 0.0 && !self.parallel && self.spot.is_none()
    }
}

/// A cone of light with a soft edge.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spot {
    /// Where it points, of length 1.
    pub aim: Vec3A,
    /// The cosines of the angles from `aim` beyond which it is dark, and within which it is bright; the first is smaller.
    /// Between them brightness is `s^2 (3 - 2 s)`, s rising from 0 to 1 with the cosine.
    pub dark: f32,
    /// See `dark`.
    pub bright: f32,
}
