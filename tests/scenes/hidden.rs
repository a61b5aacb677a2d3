use crate::materials::bright;
use crate::{Random, solids};
use eightfold_tracer::scene::{Camera, Light, List, Material, Plane, Scene, Sphere};
use glam::{Vec3, vec3};

pub const GREY: Material = Material::matt(Vec3::splat(0.8), 0.9);

/// Returns forty small objects above a floor, and a light; `are_blocks` is for even and odd objects.
pub fn hidden(random: &mut Random, are_blocks: [bool; 2], floor: Material) -> Scene {
    let eye = random.vector(vec3(-6.0, 2.0, 11.0), vec3(6.0, 8.0, 11.0));
    let light = random.vector(vec3(-6.0, 5.0, -6.0), vec3(6.0, 9.0, 6.0));
    let mut scene = Scene {
        camera: Camera::new(eye, Vec3::ZERO, random.between(0.6, 1.0)),
        background: Vec3::splat(0.1),
        ambient: Vec3::splat(0.2),
        planes: List::of(&[Plane::new(Vec3::ZERO, 20.0, 20.0, floor)]),
        lights: List::of(&[Light::new(light, Vec3::ONE)]),
        ..Scene::default()
    };
    for number in 0..40 {
        let centre = random.vector(vec3(-5.0, 0.5, -5.0), vec3(5.0, 3.0, 5.0));
        let (small, material) = (random.power(-2.0, -0.3), bright(number));
        if are_blocks[number % 2] {
            let thin = random.vector(Vec3::splat(0.03), Vec3::splat(0.3)).with_y(1.0);
            scene.blocks.push(solids::block(random, centre, 2.0 * small * thin, material));
        } else {
            scene.spheres.push(Sphere::new(centre, small, material));
        }
    }
    scene
}
