//! What a scene file says, as it is written: the fields of [`Scene`] by their names, with materials in a table of their own.

use super::motion::Motion;
use eightfold::glam::Mat3A;
use eightfold::scene::{self, Scene, Shape};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A point, a direction or a colour.
type Vector = [f32; 3];

/// A scene file. What it leaves out is as in [`Scene::default`].
#[derive(Clone, Debug, Serialize, Deserialize, PartialEq)]
#[serde(rename = "Scene", default, deny_unknown_fields)]
pub struct Description {
    /// How long the scene plays, in seconds.
    pub length: f32,
    pub camera: Camera,
    pub background: Vector,
    pub sky: Vector,
    pub haze: f32,
    pub fade: f32,
    pub film: Film,
    pub ambient: Vector,
    pub method: Method,
    /// The materials by name.
    pub materials: BTreeMap<String, Material>,
    pub spheres: Vec<Sphere>,
    pub planes: Vec<Plane>,
    pub water: Waves,
    pub blocks: Vec<Block>,
    pub lights: Vec<Light>,
    pub captions: Vec<Caption>,
    /// Numbers that change with time.
    pub motions: Vec<Motion>,
}

/// See [`scene::Camera`].
#[derive(Clone, Debug, Serialize, Deserialize, PartialEq)]
#[serde(default, deny_unknown_fields)]
pub struct Camera {
    pub eye: Vector,
    pub look_at: Vector,
    pub up: Vector,
    pub field_of_view: f32,
}

/// See [`scene::Film`].
#[derive(Clone, Debug, Serialize, Deserialize, PartialEq)]
#[serde(default, deny_unknown_fields)]
pub struct Film {
    pub shoulder: f32,
    pub vignette: f32,
    pub dither: f32,
    pub tolerance: f32,
}

/// See [`scene::Method`].
#[derive(Clone, Debug, Serialize, Deserialize, PartialEq)]
#[serde(default, deny_unknown_fields)]
pub struct Method {
    pub points: f32,
    pub squares: f32,
    pub picture: f32,
    pub coarse: f32,
    pub front: f32,
}

/// See [`scene::Material`].
#[derive(Clone, Debug, Serialize, Deserialize, PartialEq)]
#[serde(default, deny_unknown_fields)]
pub struct Material {
    pub colour: Vector,
    pub kd: f32,
    pub ks: f32,
    pub exponent: f32,
    pub metallic: f32,
    pub anisotropy: f32,
    pub kr: f32,
    pub fresnel: f32,
    pub kt: f32,
    pub index: f32,
    pub tint: Vector,
    pub pattern: Pattern,
}

/// See [`scene::Pattern`].
#[derive(Clone, Debug, Serialize, Deserialize, PartialEq)]
#[serde(default, deny_unknown_fields)]
pub struct Pattern {
    pub waves: Vector,
    pub depth: f32,
    pub edge: f32,
    pub balance: f32,
    pub warp: f32,
    pub grain: f32,
}

/// See [`scene::Sphere`].
#[derive(Clone, Debug, Default, Serialize, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Sphere {
    pub centre: Vector,
    pub radius: f32,
    pub material: String,
}

/// See [`scene::Plane`].
#[derive(Clone, Debug, Default, Serialize, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Plane {
    pub centre: Vector,
    pub half_x: f32,
    pub half_z: f32,
    pub material: String,
}

/// See [`scene::Waves`].
#[derive(Clone, Debug, Default, Serialize, Deserialize, PartialEq)]
#[serde(default, deny_unknown_fields)]
pub struct Waves {
    pub slope: f32,
    pub length: f32,
    pub phase: f32,
}

/// See [`scene::Block`].
#[derive(Clone, Debug, Default, Serialize, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Block {
    #[serde(default, with = "NamedShape")]
    pub shape: Shape,
    pub centre: Vector,
    pub half: Vector,
    /// Its own axes in scene coordinates.
    #[serde(default = "identity")]
    pub axes: [Vector; 3],
    /// Besides, the angles by which it is turned, in radians: about its own z axis first, then x, then y.
    #[serde(default)]
    pub turn: Vector,
    pub material: String,
}

/// How [`Shape`] is written.
#[derive(Serialize, Deserialize)]
#[serde(remote = "Shape")]
enum NamedShape {
    Box,
    Cylinder,
}

/// See [`scene::Light`].
#[derive(Clone, Debug, Default, Serialize, Deserialize, PartialEq)]
#[serde(default, deny_unknown_fields)]
pub struct Light {
    pub position: Vector,
    pub colour: Vector,
    pub radius: f32,
    pub parallel: bool,
    pub size: f32,
    pub glow: f32,
    pub spot: Option<Spot>,
}

/// See [`scene::Spot`].
#[derive(Clone, Debug, Serialize, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Spot {
    pub aim: Vector,
    pub dark: f32,
    pub bright: f32,
}

/// See [`scene::Caption`].
#[derive(Clone, Debug, Serialize, Deserialize, PartialEq)]
#[serde(default, deny_unknown_fields)]
pub struct Caption {
    pub letters: String,
    pub middle: f32,
    pub size: f32,
    pub brightness: f32,
}

fn identity() -> [Vector; 3] {
    Mat3A::IDENTITY.to_cols_array_2d()
}

impl Default for Description {
    fn default() -> Self {
        Self {
            length: eightfold::show::MODEL_LENGTH,
            ..Self::of(&Scene::default())
        }
    }
}

impl Default for Camera {
    fn default() -> Self {
        scene::Camera::default().into()
    }
}

impl Default for Film {
    fn default() -> Self {
        scene::Film::default().into()
    }
}

impl Default for Method {
    fn default() -> Self {
        scene::Method::default().into()
    }
}

impl Default for Material {
    fn default() -> Self {
        scene::Material::BLACK.into()
    }
}

impl Default for Pattern {
    fn default() -> Self {
        scene::Pattern::NONE.into()
    }
}

impl Default for Caption {
    /// Such as the show's.
    fn default() -> Self {
        Self {
            letters: String::new(),
            middle: 0.9,
            size: 0.05,
            brightness: 1.0,
        }
    }
}
