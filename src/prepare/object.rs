//! What a ray hits.

use crate::scene::{Block, Light, Material, Plane, Scene, Sphere};

/// An object of a scene.
pub(crate) enum Object<'a> {
    Sphere(&'a Sphere),
    Block(&'a Block),
    Plane(&'a Plane),
    /// What a light is drawn as.
    Lamp(&'a Light),
    /// The background.
    Nothing,
}

/// The object number `i` of a scene, and its material: spheres, then boxes and cylinders, lights, planes, background.
#[inline(never)]
pub(super) fn of(scene: &Scene, mut i: usize) -> (Object<'_>, &Material) {
    if let Some(sphere) = scene.spheres.get(i) {
        return (Object::Sphere(sphere), &sphere.material);
    }
    i -= scene.spheres.len();
    if let Some(block) = scene.blocks.get(i) {
        return (Object::Block(block), &block.material);
    }
    i -= scene.blocks.len();
    if let Some(light) = scene.lights.get(i) {
        return (Object::Lamp(light), &Material::BLACK);
    }
    match scene.planes.get(i - scene.lights.len()) {
        Some(plane) => (Object::Plane(plane), &plane.material),
        None => (Object::Nothing, &Material::BLACK),
    }
}
