//! What only some scenes have: boxes and cylinders, patterns, air, lamps that are more than points.

use super::groups::Groups;
use crate::DETAILS;
use crate::scene::{Block, Light, Material, Method, Scene, Sphere};
use glam::Vec3A;

/// All of that, for one frame.
pub(crate) struct Details {
    is_there: bool,
    /// Whether more than the plain picture is shown.
    pub shows_method: bool,
    /// The scene as it was given.
    pub scene: Scene,
    /// The side of a pixel at distance 1.
    pub pixel: f32,
}

/// What a ray hits.
pub(crate) enum Object<'a> {
    Sphere(&'a Sphere),
    Block(&'a Block),
    /// A horizontal plane around a centre.
    Plane(Vec3A),
    Lamp,
    Nothing,
}

impl Details {
    /// Nothing, all zeros.
    pub const NONE: Self = Self {
        is_there: false,
        shows_method: false,
        scene: Scene::NONE,
        pixel: 0.0,
    };

    /// Whether there is any of it but for lamps.
    #[inline(always)]
    pub fn is_there(&self) -> bool {
        DETAILS && self.is_there
    }

    /// Takes a scene in.
    pub fn set(&mut self, scene: &Scene, pixel: f32) {
        if !DETAILS {
            return;
        }
        let has_pattern = |material: &Material| material.pattern.depth != 0.0;
        self.is_there = scene.haze != 0.0
            || scene.sky != Vec3A::ZERO
            || !scene.blocks.is_empty()
            || scene.spheres.iter().any(|s| has_pattern(&s.material))
            || scene.planes.iter().any(|p| has_pattern(&p.material));
        let Method {
            points,
            squares,
            picture,
        } = scene.method;
        // Not where the first two are 0 and the last 1: all are in 0 to 1.
        self.shows_method = picture - points - squares != 1.0;
        self.scene = *scene;
        self.pixel = pixel;
    }

    /// The object number `i`, and its material.
    pub fn object(&self, groups: &Groups, i: usize) -> (Object<'_>, &Material) {
        let scene = &self.scene;
        let order = groups.order();
        if let Some(&number) = order.get(i) {
            let number = number as usize;
            if let Some(sphere) = scene.spheres.get(number) {
                return (Object::Sphere(sphere), &sphere.material);
            }
            if let Some(block) = scene.blocks.get(number - scene.spheres.len()) {
                return (Object::Block(block), &block.material);
            }
        }
        let i = i.wrapping_sub(order.len());
        if i < scene.lights.len() {
            return (Object::Lamp, &Material::BLACK);
        }
        match scene.planes.get(i.wrapping_sub(scene.lights.len())) {
            Some(plane) => (Object::Plane(plane.centre), &plane.material),
            None => (Object::Nothing, &Material::BLACK),
        }
    }

    /// The lamp number `i`.
    pub fn light(&self, i: usize) -> &Light {
        &self.scene.lights[i]
    }
}
