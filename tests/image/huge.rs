//! Objects whose size is many times the eye's height above them: the ground, and planets.

use crate::drawn::draw_by_all;
use crate::error::Difference;
use eightfold_oracle::frame::Frame as Traced;
use eightfold_scenes::solids::SHAPES;
use eightfold_tracer::Quality;
use eightfold_tracer::scene::{Block, Camera, Light, List, Material, Scene, Sphere};
use glam::{Vec3, vec3};

/// The eye at a height above a sphere, and a ball and a mirror before it.
fn above(radius: f32, height: f32, light: f32) -> Scene {
    let ground = Material::matt(Vec3::splat(0.5), 0.9);
    let mirror = Material::mirror(0.8);
    let ball = Material::matt(vec3(0.9, 0.3, 0.2), 0.8);
    let eye = height * vec3(0.0, 1.0, 4.0);
    Scene {
        camera: Camera::new(eye, 0.5 * height * Vec3::Y, 0.8),
        background: Vec3::ONE,
        ambient: Vec3::splat(0.2),
        spheres: List::of(&[
            Sphere::new(-radius * Vec3::Y, radius, ground),
            Sphere::new(height * vec3(-0.6, 0.7, 0.0), 0.5 * height, mirror),
            Sphere::new(height * vec3(0.6, 0.7, 0.0), 0.5 * height, ball),
        ]),
        lights: List::of(&[Light::new(light * vec3(0.5, 1.0, 0.3), Vec3::splat(0.5))]),
        ..Scene::default()
    }
}

#[test]
fn eye_near_a_huge_sphere_sees_it_as_in_f64() {
    for radius in [1e3, 1e5, 3e6, 1e8] {
        for height in [1e-7, 5e-7, 1e-6, 2e-6, 1e-5] {
            let height = radius * height;
            for light in [3.0, 10.0] {
                let scene = above(radius, height, light * height);
                assert_eq!(scene.validate(), Ok(()));
                let expected = Traced::new(&scene, &Quality::EXHAUSTIVE, 80, 60).picture();
                for (isa, drawn) in draw_by_all(&scene, &Quality::EXHAUSTIVE, 80, 60) {
                    let psnr = Difference::between(&expected, &drawn.pixels).psnr;
                    let what = format!("{} {radius} {height} {light}: {psnr} dB", isa.name);
                    println!("{what}");
                    // The points of the sphere have an error of 6e-8 radii.
                    let least = if height < 2e-7 * radius { 25.0 } else { 35.0 };
                    assert!(psnr >= least, "{what}");
                }
            }
        }
    }
}

#[test]
fn eye_near_a_huge_block_sees_it_lit() {
    for shape in SHAPES {
        for (size, height) in [(1e3, 2e-3), (1e5, 0.2), (3e6, 3.0), (3e6, 20.0)] {
            let mut scene = above(size, height, 8.0 * height);
            let material = scene.spheres[0].material;
            scene.spheres.clear();
            let (centre, half) = (-size * Vec3::Y, Vec3::splat(size));
            scene.blocks.push(Block::new(shape, centre, half, material));
            let expected = Traced::new(&scene, &Quality::EXHAUSTIVE, 80, 60).picture();
            for (isa, drawn) in draw_by_all(&scene, &Quality::EXHAUSTIVE, 80, 60) {
                let psnr = Difference::between(&expected, &drawn.pixels).psnr;
                let what = format!("{} {shape:?} {size} {height}: {psnr} dB", isa.name);
                println!("{what}");
                assert!(psnr >= 25.0, "{what}");
            }
        }
    }
}
