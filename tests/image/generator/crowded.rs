//! Scenes crowded by mirrors, glass and matt things of all shapes, as somebody's scene file might be.

use super::fitting;
use super::seeded::Random;
use eightfold_tracer::scene::{Block, Camera, Light, List, Material, Plane, Scene, Shape, Sphere};
use glam::{EulerRot, Mat3, Vec3, vec3};

/// Half the side of the cube that the things are in, above a floor.
const REACH: f32 = 5.0;

/// A material in some colour: glass and mirrors by these shares, or else one that shines.
fn material(random: &mut Random, [glass, mirrors]: [f32; 2]) -> Material {
    let kind = random.between(0.0, 1.0);
    let plastic = Material {
        colour: random.vector(Vec3::splat(0.05), Vec3::ONE),
        kd: 0.8,
        ks: random.between(0.0, 1.0),
        exponent: 60.0,
        ..Material::BLACK
    };
    if kind < glass {
        Material {
            kd: 0.1,
            kr: 0.1,
            kt: 0.8,
            index: random.between(1.1, 1.6),
            ..plastic
        }
    } else if kind < glass + mirrors {
        Material {
            kd: 0.2,
            kr: random.between(0.3, 0.8),
            ..plastic
        }
    } else {
        plastic
    }
}

/// So many spheres and blocks before a sky.
pub fn crowded(random: &mut Random, [spheres, blocks]: [usize; 2], shares: [f32; 2]) -> Scene {
    let mut scene = Scene {
        camera: Camera {
            eye: vec3(
                0.0,
                random.between(0.6, 8.0),
                REACH * random.between(1.0, 2.2),
            ),
            look_at: Vec3::Y * REACH * random.between(0.1, 0.5),
            up: Vec3::Y,
            field_of_view: random.between(0.5, 1.2),
        },
        background: random.vector(Vec3::ZERO, Vec3::splat(0.8)),
        ambient: Vec3::splat(0.2),
        planes: List::of(&[Plane {
            half_x: 20.0,
            half_z: 20.0,
            material: material(random, [0.0, shares[1]]),
            ..Plane::default()
        }]),
        ..Scene::default()
    };
    let place =
        |random: &mut Random| random.vector(vec3(-REACH, 0.0, -REACH), vec3(REACH, REACH, REACH));
    for _ in 0..spheres {
        scene.spheres.push(Sphere::new(
            place(random),
            random.between(0.1, 0.4),
            material(random, shares),
        ));
    }
    for _ in 0..blocks {
        let shape = [Shape::Box, Shape::Cylinder, Shape::Capsule][random.below(3)];
        let half = random.vector(vec3(0.05, 0.3, 0.05), vec3(0.3, 2.0, 0.5));
        let [a, b, c] = [0; 3].map(|_| random.between(0.0, 6.0));
        scene.blocks.push(Block {
            centre: place(random),
            half: fitting(shape, half),
            axes: Mat3::from_euler(EulerRot::XYZ, a, b, c),
            shape,
            material: material(random, shares),
        });
    }
    for _ in 0..1 + random.below(3) {
        scene.lights.push(Light::new(
            random.vector(vec3(-9.0, 6.0, -9.0), vec3(9.0, 12.0, 9.0)),
            Vec3::splat(random.between(0.3, 1.0)),
        ));
    }
    scene
}
