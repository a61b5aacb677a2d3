use crate::scene::{Block, Light, Material, Plane, Scene, Sphere};
use glam::Vec3;

pub(crate) enum Object<'a> {
    Sphere(&'a Sphere),
    Block(&'a Block),
    Plane(&'a Plane),
    Light(&'a Light),
    /// Hit by rays that hit no other object.
    Background,
}

impl Object<'_> {
    pub fn centre(&self) -> Vec3 {
        match self {
            Self::Sphere(sphere) => sphere.centre,
            Self::Block(block) => block.centre,
            Self::Plane(plane) => plane.centre,
            Self::Light(light) => light.position,
            Self::Background => Vec3::ZERO,
        }
    }
}

/// The number of an object: spheres first, then blocks, lights, planes and the background.
///
/// A sample's word has the number plus 1 in 14 bits; 0 is no object.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd)]
pub(crate) struct ObjectId(u16);

zero! { ObjectId = Self::FIRST; }

impl ObjectId {
    pub const FIRST: Self = Self(0);

    pub const fn new(number: usize) -> Self {
        Self(number as u16)
    }

    pub const fn index(self) -> usize {
        self.0 as usize
    }

    pub const fn lane(self) -> u32 {
        self.0 as u32
    }
}

pub(super) fn of(scene: &Scene, id: ObjectId) -> (Object<'_>, &Material) {
    let mut i = id.index();
    if let Some(sphere) = scene.spheres.get(i) {
        return (Object::Sphere(sphere), &sphere.material);
    }
    i -= scene.spheres.len();
    if let Some(block) = scene.blocks.get(i) {
        return (Object::Block(block), &block.material);
    }
    i -= scene.blocks.len();
    if let Some(light) = scene.lights.get(i) {
        return (Object::Light(light), &Material::BLACK);
    }
    match scene.planes.get(i - scene.lights.len()) {
        Some(plane) => (Object::Plane(plane), &plane.material),
        None => (Object::Background, &Material::BLACK),
    }
}
