use crate::{Random, solids};
use eightfold_tracer::scene::{Camera, Light, List, Material, Pattern, Plane, Scene, Sphere};
use glam::{Vec3, vec3};

/// Half the side of the cube above the floor that contains the objects.
const REACH: f32 = 5.0;

fn material(random: &mut Random, [glass, mirrors]: [f32; 2]) -> Material {
    let kind = random.between(0.0, 1.0);
    let mut plastic = Material {
        colour: random.vector(Vec3::splat(0.05), Vec3::ONE),
        ks: random.between(0.0, 1.0),
        exponent: 60.0,
        ..Material::BLACK
    };
    let (kd, kr, kt) = if kind < glass {
        plastic.index = random.between(1.1, 1.6);
        (0.1, 0.1, 0.8)
    } else if kind < glass + mirrors {
        (0.2, random.between(0.3, 0.8), 0.0)
    } else {
        (0.8, 0.0, 0.0)
    };
    Material { kd, kr, kt, ..plastic }
}

/// Returns a crowd with these shares of glass and mirrors, over checkers or a plain floor. Up to sixteen objects are large, and
/// large glass spheres contain up to three others.
pub fn crowd(random: &mut Random, [spheres, blocks]: [usize; 2], shares: [f32; 2]) -> Scene {
    let (height, away) = (random.between(0.6, 8.0), random.between(1.0, 2.2));
    let eye = vec3(0.0, height, REACH * away);
    let look_at = Vec3::Y * REACH * random.between(0.1, 0.5);
    let mut floor = material(random, [0.0, shares[1]]);
    if random.below(2) == 0 {
        floor.pattern = Pattern::checkers(random.between(0.3, 1.5), 0.7);
    }
    let mut scene = Scene {
        camera: Camera::new(eye, look_at, random.between(0.5, 1.2)),
        background: random.vector(Vec3::ZERO, Vec3::splat(0.8)),
        ambient: Vec3::splat(0.2),
        planes: List::of(&[Plane::new(Vec3::ZERO, 20.0, 20.0, floor)]),
        ..Scene::default()
    };
    let place = |random: &mut Random| random.vector(vec3(-REACH, 0.0, -REACH), Vec3::splat(REACH));
    let is_large = spheres + blocks <= 16;
    let size = if is_large { 3.0 } else { 1.0 };
    for _ in 0..spheres {
        let (centre, mut radius) = (place(random), size * random.between(0.1, 0.4));
        let mut sphere = Sphere::new(centre, radius, material(random, shares));
        scene.spheres.push(sphere);
        for _ in 0..random.below(4) * usize::from(is_large && sphere.material.kt > 0.0) {
            radius *= random.one_of([0.999, 0.95, 0.8, 0.5]);
            sphere = Sphere::new(centre, radius, material(random, shares));
            scene.spheres.push(sphere);
        }
    }
    for _ in 0..blocks {
        let half = size * random.vector(vec3(0.05, 0.3, 0.05), vec3(0.3, 2.0, 0.5));
        let (centre, material) = (place(random), material(random, shares));
        scene.blocks.push(solids::block(random, centre, half, material));
    }
    for _ in 0..1 + random.below(3) {
        let position = random.vector(vec3(-9.0, 6.0, -9.0), vec3(9.0, 12.0, 9.0));
        let colour = Vec3::splat(random.between(0.3, 1.0));
        scene.lights.push(Light::new(position, colour));
    }
    scene
}
