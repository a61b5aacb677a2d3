use super::*;
use crate::scene::{Block, Camera, Light, Plane, Shape, Spot, Waves};
use glam::{Mat3, vec3};

const PLASTIC: Material = Material {
    colour: vec3(0.9, 0.15, 0.12),
    kd: 0.7,
    ks: 0.5,
    exponent: 40.0,
    kr: 0.25,
    ..Material::BLACK
};
const MIRROR: Material = Material { kr: 0.7, ..PLASTIC };
const GLASS: Material = Material::glass(1.5);

/// Returns the model scene of the measurements at rest.
pub fn model() -> Scene {
    let sphere = |x, y, z, material| Sphere::new(vec3(x, y, z), y, material);
    let light = |x, y, z, brightness| Light {
        drawn_radius: 0.15,
        ..Light::new(vec3(x, y, z), Vec3::splat(brightness))
    };
    Scene {
        camera: Camera {
            eye: vec3(1.9, 2.2, -7.3),
            look_at: vec3(0.0, 0.9, 0.0),
            ..Camera::default()
        },
        background: vec3(0.10, 0.12, 0.20),
        ambient: Vec3::splat(0.12),
        spheres: List::of(&[
            sphere(-2.2, 1.0, 0.5, PLASTIC),
            sphere(0.0, 1.2, 1.8, MIRROR),
            sphere(2.2, 1.0, 0.3, PLASTIC),
            sphere(0.6, 0.5, -1.6, GLASS),
        ]),
        planes: List::of(&[Plane::new(Vec3::ZERO, 12.0, 12.0, PLASTIC)]),
        lights: List::of(&[light(-4.0, 6.0, -4.0, 0.9), light(5.0, 5.0, -2.0, 0.4)]),
        ..Scene::default()
    }
}

/// Returns the model scene with `count` small spheres in rows on the floor.
pub fn rows(count: usize) -> Scene {
    let mut scene = model();
    scene.spheres.clear();
    for i in 0..count {
        let [column, row] = [i % 18, i / 18].map(|cell| 0.9 * (cell as f32 - 9.0));
        let radius = 0.2 + 0.02 * (i % 7) as f32;
        scene.spheres.push(Sphere::new(
            vec3(column, radius, row),
            radius,
            [PLASTIC, PLASTIC, MIRROR, PLASTIC, GLASS][i % 5],
        ));
    }
    scene
}

/// Returns a scene with blocks, haze, a pattern, waves, a soft light and a spotlight.
pub fn rich() -> Scene {
    let mut scene = model();
    for (x, shape) in [(-1.0, Shape::Box), (1.2, Shape::Cylinder)] {
        scene.blocks.push(Block {
            centre: vec3(x, 0.7, 2.5),
            half: vec3(0.6, 0.7, 0.6),
            axes: Mat3::from_rotation_z(0.3),
            shape,
            material: scene.spheres[0].material,
        });
    }
    scene.planes[0].material.pattern.waves = Vec3::ONE;
    scene.planes[0].material.pattern.depth = 0.5;
    scene.water = Waves { slope: 0.1, length: 2.0, phase: 0.3 };
    scene.haze = 0.03;
    scene.lights[0].diameter = 1.0;
    scene.lights[1].spot =
        Some(Spot { aim: -scene.lights[1].position, outer_angle: 0.9273, inner_angle: 0.45 });
    scene
}
