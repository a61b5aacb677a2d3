//! Light of the surroundings: what is seen is known in closed form.

use super::{WHITE, assert_near, drawn, floor, seen};
use eightfold_lab::arguments::Size;
use eightfold_lab::truth::effects::Effects;
use eightfold_tracer::glam::{DVec3, Mat3A, Vec3A, vec3a};
use eightfold_tracer::scene::{Block, Camera, List, Material, Plane, Scene, Shape, Sphere};
use std::f64::consts::TAU;

/// A surface that keeps all light, in a way of its own.
fn keeping(kd: f32, kr: f32, kt: f32) -> Material {
    Material {
        kd,
        kr,
        kt,
        index: 1.5,
        ..WHITE
    }
}

#[test]
fn nothing_is_seen_in_a_white_furnace() {
    // Whatever takes no light looks like its surroundings if these are the same everywhere.
    let sphere = |x: f32, material| Sphere::new(vec3a(x, 0.2, 0.3 * x), 0.6, material);
    let block = |z, shape| Block {
        centre: vec3a(0.7, 0.1, z),
        half: Vec3A::splat(0.4),
        axes: Mat3A::from_rotation_y(0.4),
        shape,
        material: keeping(0.6, 0.4, 0.0),
    };
    let scene = Scene {
        camera: Camera {
            eye: vec3a(0.0, 1.0, 5.0),
            ..Camera::default()
        },
        background: vec3a(0.5, 0.25, 1.0),
        spheres: List::of(&[
            sphere(-1.2, WHITE),
            sphere(0.0, keeping(0.0, 0.1, 0.9)),
            sphere(1.2, keeping(0.0, 1.0, 0.0)),
        ]),
        blocks: List::of(&[
            block(1.4, Shape::Box),
            block(-1.4, Shape::Cylinder),
            block(-2.6, Shape::Capsule),
        ]),
        planes: List::of(&[Plane::new(
            vec3a(0.0, -0.5, 0.0),
            2.0,
            2.0,
            keeping(0.7, 0.3, 0.0),
        )]),
        ..Scene::default()
    };
    let size = Size::new(16, 12);
    let background = scene.background.as_dvec3();
    let all = drawn(&scene, size, Effects::TRUTH, 256);
    for estimate in &all {
        // Each pixel is near, as far as 192 of them can be.
        let allowed = 3.0 * estimate.half_interval().max_element() + 1e-9;
        assert!((estimate.mean - background).abs().max_element() <= allowed);
    }
    let mean: DVec3 = all.iter().map(|estimate| estimate.mean).sum::<DVec3>() / all.len() as f64;
    assert!(
        (mean / background - 1.0).abs().max_element() < 0.005,
        "{mean}"
    );
}

#[test]
fn a_sphere_on_black_ground_gets_the_sky_that_it_faces() {
    // At a point whose normal has the height y, the sky above the horizon gives (1 + y) / 2 of what all of it would.
    for height in [-0.7, 0.0, 0.4, 0.95_f32] {
        let normal = vec3a((1.0 - height * height).sqrt(), height, 0.0);
        let mut scene = floor(Material::BLACK);
        scene.background = Vec3A::splat(0.8);
        scene.spheres = List::of(&[Sphere::new(vec3a(0.0, 1.0, 0.0), 1.0, WHITE)]);
        scene.camera.look_at = vec3a(0.0, 1.0, 0.0) + normal;
        scene.camera.eye = scene.camera.look_at + 0.1 * normal;
        scene.camera.up = Vec3A::Z;
        let known = 0.8 * 0.5 * (1.0 + f64::from(height));
        assert_near(
            seen(&scene, Effects::TRUTH, 2048),
            DVec3::splat(known),
            0.02,
        );
    }
}

/// The form factor of a rectangle of a by b at the distance 1, for a parallel surface opposite its corner (Howell, B-3).
fn corner_factor(a: f64, b: f64) -> f64 {
    let part = |a: f64, b: f64| {
        let root = (1.0 + a * a).sqrt();
        a / root * (b / root).atan()
    };
    (part(a, b) + part(b, a)) / TAU
}

/// Asserts that something black over a white floor, under a sky of 1, takes the share `factor` of the light.
#[track_caller]
fn assert_hides(scene: &mut Scene, factor: f64) {
    scene.background = Vec3A::ONE;
    let known = DVec3::splat(1.0 - factor);
    assert_near(seen(scene, Effects::TRUTH, 4096), known, 0.02);
}

#[test]
fn a_rectangle_hides_its_form_factor_of_the_sky() {
    for (half_x, half_z, height) in [(0.5, 0.8, 1.0), (2.0, 0.3, 1.5), (1.5, 1.5, 0.7)] {
        // By four rectangles that meet above the point; by a plane, and by a thin box.
        let factor = 4.0 * corner_factor(half_x / height, half_z / height);
        let (x, y, z) = (half_x as f32, height as f32, half_z as f32);
        let mut scene = floor(WHITE);
        let plane = Plane::new(y * Vec3A::Y, x, z, Material::BLACK);
        scene.planes.push(plane);
        assert_hides(&mut scene, factor);
        let mut scene = floor(WHITE);
        let (centre, half) = ((y + 1e-4) * Vec3A::Y, vec3a(x, 1e-4, z));
        let block = Block::new(Shape::Box, centre, half, Material::BLACK);
        scene.blocks.push(block);
        assert_hides(&mut scene, factor);
    }
    // To the side, from x = 1 to 2, z = -0.5 to 0.5, at the height 1: the difference of two corners.
    let factor = 2.0 * (corner_factor(2.0, 0.5) - corner_factor(1.0, 0.5));
    let mut scene = floor(WHITE);
    scene.camera.eye.x = -4.0;
    let plane = Plane::new(vec3a(1.5, 1.0, 0.0), 0.5, 0.5, Material::BLACK);
    scene.planes.push(plane);
    assert_hides(&mut scene, factor);
}

#[test]
fn a_disc_hides_its_form_factor_of_the_sky() {
    for (radius, height) in [(0.5_f32, 1.0_f32), (1.2, 0.7), (0.3, 2.0)] {
        let mut scene = floor(WHITE);
        scene.blocks.push(Block::new(
            Shape::Cylinder,
            vec3a(0.0, height + 1e-4, 0.0),
            vec3a(radius, 1e-4, radius),
            Material::BLACK,
        ));
        let (radius2, height2) = (f64::from(radius).powi(2), f64::from(height).powi(2));
        assert_hides(&mut scene, radius2 / (radius2 + height2));
    }
}

#[test]
fn light_between_two_surfaces_is_that_of_the_series() {
    // Inside a closed sphere of albedo a that surrounds all, with haze so dense that every ray ends in the background after the
    // share T: L = (1 - T) B + T a L.
    let (albedo, haze, radius) = (0.6, 0.5, 1.0);
    let mut scene = Scene {
        camera: Camera {
            eye: vec3a(0.0, 0.0, 0.999),
            ..Camera::default()
        },
        background: Vec3A::ONE,
        haze,
        ..Scene::default()
    };
    scene.spheres.push(Sphere::new(
        Vec3A::ZERO,
        radius,
        Material {
            kd: albedo,
            ..WHITE
        },
    ));
    // The chord from a point of the sphere in a direction at an angle of cosine c is 2 c long; its mean transmittance weighted
    // by 2 c is what scattered light passes.
    let haze2 = 4.0 * f64::from(haze * haze);
    let scattered = (1.0 + haze2).ln() / haze2;
    let albedo = f64::from(albedo);
    let around = (1.0 - scattered) / (1.0 - scattered * albedo);
    // The camera is at the edge of the sphere and sees all of the diameter.
    let along = f64::from(haze) * 1.999;
    let clear = 1.0 / (1.0 + along * along);
    let known = (1.0 - clear) + clear * albedo * around;
    assert_near(
        seen(&scene, Effects::TRUTH, 4096),
        DVec3::splat(known),
        0.02,
    );
}
