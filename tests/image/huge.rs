//! Objects whose size is many times the eye's height above them: the ground, and planets.

use crate::drawn::{draw, draw_by_all, isa_of};
use crate::error::Difference;
use eightfold_oracle::Oracle;
use eightfold_oracle::frame::Frame as Traced;
use eightfold_scenes::solids::SHAPES;
use eightfold_scenes::{Random, cases};
use eightfold_tracer::Quality;
use eightfold_tracer::scene::{Block, Camera, Light, List, Material, Scene, Shape, Sphere};
use glam::{Vec3, vec3};

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

#[track_caller]
pub fn assert_near(scene: &Scene, [width, height]: [usize; 2], min_psnr: f64, what: &str) {
    assert_eq!(scene.validate(), Ok(()));
    let frame = Traced::new(scene, &Quality::EXHAUSTIVE, width, height);
    for (isa, drawn) in draw_by_all(scene, &Quality::EXHAUSTIVE, width, height) {
        let psnr = Difference::between(&frame.picture_like(&drawn.pixels), &drawn.pixels).psnr;
        assert!(psnr >= min_psnr, "{}, {what}: {psnr} dB", isa.name);
    }
}

#[test]
fn eye_near_a_huge_sphere_sees_it_as_in_f64() {
    for radius in [1e3, 1e5, 3e6, 1e8] {
        // The points of the sphere have an error of 6e-8 radii.
        for (height, min_psnr) in [(1e-7, 25.0), (5e-7, 35.0), (1e-6, 35.0), (1e-5, 35.0)] {
            for light in [3.0, 10.0] {
                let scene = above(radius, radius * height, light * radius * height);
                assert_near(&scene, [80, 60], min_psnr, &format!("{radius} {height} {light}"));
            }
        }
    }
}

#[test]
fn eye_near_a_huge_block_sees_it_lit() {
    for shape in SHAPES {
        for (size, height) in [(1e3, 2e-3), (1e5, 0.2), (3e6, 3.0), (3e6, 20.0)] {
            let mut scene = above(size, height, 8.0 * height);
            let Sphere { centre, material, .. } = scene.spheres[0];
            scene.spheres.clear();
            scene.blocks.push(Block::new(shape, centre, Vec3::splat(size), material));
            assert_near(&scene, [80, 60], 25.0, &format!("{shape:?} {size} {height}"));
        }
    }
}

#[test]
fn telescope_sees_a_far_sphere_as_in_f64() {
    for distance in [1e1, 1e2, 1e3, 1e4] {
        let mut scene = above(1.0, 1.0, 5.0);
        scene.camera.eye *= distance / scene.camera.eye.length();
        scene.camera.field_of_view = 4.0 / distance;
        assert_near(&scene, [80, 60], 40.0, &format!("from {distance} radii"));
    }
}

/// Returns a white ball. The distances are in radii. A box beyond the ball, and the diameter of a light inside, make no difference.
fn ball(random: &mut Random, [eye_at, light_at]: [f32; 2], has_more: bool) -> Scene {
    let radius = random.power(-4.0, 4.0);
    let centre = random.vector(Vec3::NEG_ONE, Vec3::ONE) * random.power(0.0, 3.0) * radius;
    let mut from = |distance: f32| centre + random.turn() * Vec3::X * (distance * radius);
    let white = Material::matt(Vec3::ONE, 1.0);
    let mut scene = Scene {
        camera: Camera::new(from(eye_at), centre, (2.0 / eye_at).min(1.5)),
        spheres: List::of(&[Sphere::new(centre, radius, white)]),
        lights: List::of(&[Light::new(from(light_at), Vec3::ONE)]),
        ..Scene::default()
    };
    if has_more {
        let half = Vec3::splat(radius);
        scene.blocks.push(Block::new(Shape::Box, from(3.0), half, white));
        scene.lights[0].diameter = 1.9 * (1.0 - light_at).max(0.0) * radius;
    }
    scene
}

/// A light wholly inside a sphere illuminates its inside, others its outside. Rounding makes no point shadow itself.
#[test]
fn sphere_is_lit_on_the_side_of_its_light_only() {
    let mut counts = [0; 2];
    for mut random in cases(2000) {
        let (is_inside, has_more) = random.one_of([(false, false), (true, false), (true, true)]);
        let eye_at = if is_inside { 0.5 } else { random.power(0.1, 3.0) };
        let lights = [random.between(0.1, 0.95), random.power(0.03, 2.0)];
        let light_at = random.one_of(lights);
        let scene = ball(&mut random, [eye_at, light_at], has_more);
        let drawn = draw(isa_of(random.seed), 1, &scene, &Quality::EXHAUSTIVE, 16, 16).pixels;
        let oracle = Oracle::new(&scene, &Quality::EXHAUSTIVE, 16, 16);
        let light = scene.lights[0].position.as_dvec3();
        for (i, pixel) in drawn.into_iter().enumerate() {
            let Some(hit) = oracle.surface(oracle.ray((i % 16) as f64, (i / 16) as f64)) else {
                continue;
            };
            let cosine = hit.n.dot((light - hit.ray.o).normalize());
            let is_lit = cosine > 0.0 && is_inside == (light_at < 1.0);
            // Rounding moves grazing hits, and hides faint light.
            if cosine.abs() >= 0.01 && hit.ray.d.dot(hit.n).abs() >= 0.1 {
                assert_eq!(pixel != 0, is_lit, "case {}: {cosine}, {scene:?}", random.seed);
                counts[usize::from(is_lit)] += 1;
            }
        }
    }
    assert!(counts.into_iter().all(|count| count > 50_000), "{counts:?}");
}
