//! What is drawn: a camera, a few primitives with their materials, and lights.
//!
//! Right-handed coordinates, y up; lengths in scene units; colours linear RGB, 0 to 1. [`Scene::validate`] says whether
//! all numbers are in their ranges.

pub(crate) mod camera;
mod list;
mod validate;

pub use camera::Camera;
use glam::Vec3A as Vec3;
pub use list::List;
pub use validate::{Flaw, MAX_LENGTH, MIN_LENGTH};

/// Spheres a scene can hold: the largest scene in use, a field of 256, with room to grow.
pub const MAX_SPHERES: usize = 320;
/// Planes a scene can hold.
pub const MAX_PLANES: usize = 8;
/// Lights a scene can hold.
pub const MAX_LIGHTS: usize = 4;

/// Everything one frame shows.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    /// Where the picture is taken from.
    pub camera: Camera,
    /// What a ray sees that hits nothing.
    pub background: Vec3,
    /// Light that reaches every surface alike.
    pub ambient: Vec3,
    /// Spheres, in no particular order.
    pub spheres: List<Sphere, MAX_SPHERES>,
    /// Horizontal bounded planes.
    pub planes: List<Plane, MAX_PLANES>,
    /// Point lights, each drawn as a small sphere.
    pub lights: List<Light, MAX_LIGHTS>,
}

/// How a surface answers light, by Phong's model.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Material {
    /// Colour of the surface; highlights take the light's colour instead.
    pub colour: Vec3,
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
}

/// A sphere.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sphere {
    /// Centre.
    pub centre: Vec3,
    /// Radius, [`MIN_LENGTH`] to [`MAX_LENGTH`].
    pub radius: f32,
    /// Surface.
    pub material: Material,
}

/// A horizontal rectangle, seen from above and from below.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Plane {
    /// Middle of the rectangle.
    pub centre: Vec3,
    /// Half its extent along x, [`MIN_LENGTH`] to [`MAX_LENGTH`].
    pub half_x: f32,
    /// Half its extent along z, [`MIN_LENGTH`] to [`MAX_LENGTH`].
    pub half_z: f32,
    /// Surface.
    pub material: Material,
}

/// A point light without attenuation, visible as a small sphere that casts no shadow.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Light {
    /// Where the light comes from.
    pub position: Vec3,
    /// Colour times brightness.
    pub colour: Vec3,
    /// Radius of the sphere it is drawn as, [`MIN_LENGTH`] to [`MAX_LENGTH`].
    pub radius: f32,
}
