//! The objects of a scene by number.

use crate::scene::{Block, Light, Material, Plane, Scene, Sphere};
use glam::Vec3;

/// An object that a ray can hit.
pub(crate) enum Object<'a> {
    Sphere(&'a Sphere),
    Block(&'a Block),
    Plane(&'a Plane),
    /// The sphere that shows a light.
    Light(&'a Light),
    /// The background, which a ray hits that hits nothing else.
    Background,
}

impl Object<'_> {
    /// Returns its centre; of the background zeros.
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

/// Identifies an object of a frame: spheres have the first numbers; blocks, lights, planes and the background follow.
///
/// In the lanes of a packet an object is its [`ObjectId::lane`], a `u32`. In the word of a sample it is one more, in 14 bits, so
/// that 0 stands for none.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd)]
pub(crate) struct ObjectId(u16);

impl ObjectId {
    /// The object with the first number.
    pub const FIRST: Self = Self(0);

    /// The object with a number below [`super::MAX_OBJECTS`].
    pub const fn new(number: usize) -> Self {
        Self(number as u16)
    }

    /// Its number, as an index in arrays of all objects.
    pub const fn index(self) -> usize {
        self.0 as usize
    }

    /// Its number, as it stands in a lane.
    pub const fn lane(self) -> u32 {
        self.0 as u32
    }
}

/// An object of a scene, and its material.
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

/// As many strong mirrors, solids of strong glass among them, make a crowd: each shows the others, and small. No scene of the show has
/// more than six. With fewer, one in fifty scenes by chance of 16 blocks is below 42 dB at the default quality.
const CROWD: usize = 12;

/// The least share of light that a mirror sends back, or glass lets pass, for what it shows to matter: the qualities' `key_weight`.
const STRONG: f32 = 0.3;

/// The sine of half the angle at which the eye sees a sphere of glass that shows a crowd large enough.
const LARGE: f32 = 0.2;

/// Whether a material sends back, or lets pass, so much light that what it shows matters.
fn is_strong(material: &Material) -> bool {
    material.kr + material.kt >= STRONG
}

/// Whether a scene has a crowd of mirrors and glass. Then its squares are small, see [`FramePlan`](crate::plan::FramePlan).
pub(crate) fn is_crowd(scene: &Scene) -> bool {
    let solids = (0..scene.solids()).map(ObjectId::new);
    let strong = solids.filter(|&id| is_strong(of(scene, id).1));
    strong.count() >= CROWD
}

/// Whether an object of a crowd shows so much of its scene, so small, that two of its points tell nothing of what is between them.
pub(super) fn glitters(scene: &Scene, object: &Object<'_>, material: &Material) -> bool {
    let is_small = match object {
        Object::Sphere(sphere) => {
            let reach = LARGE * (sphere.centre - scene.camera.eye).length();
            material.kt == 0.0 || sphere.radius < reach
        }
        Object::Block(_) => true,
        Object::Plane(_) | Object::Light(_) | Object::Background => false,
    };
    is_small && is_strong(material)
}
