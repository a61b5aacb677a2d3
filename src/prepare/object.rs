//! What a ray hits.

use crate::scene::{Block, Light, Material, Plane, Scene, Sphere};

/// An object of a scene.
pub(crate) enum Object<'a> {
    Sphere(&'a Sphere),
    Block(&'a Block),
    Plane(&'a Plane),
    /// What a light is drawn as.
    Lamp(&'a Light),
    /// What is behind everything.
    Background,
}

/// The object number `i` of a scene, and its material: spheres, then boxes and cylinders, lights, planes, background.
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
        None => (Object::Background, &Material::BLACK),
    }
}

/// Waves that are not steepened have no edges: they change as slowly as light does, and squares with them are filled by their
/// corners' colours. (The show's colonnade, of marble, takes two thirds of the time by it.)
const SOFT: f32 = 1.0;

/// Whether the pattern of a material has edges, which a square must not be filled across.
pub(super) fn has_edges(material: &Material) -> bool {
    material.pattern.depth != 0.0 && material.pattern.edge > SOFT
}
