//! The model scene, the default of measurements: four spheres, a plane and two lights, after the
//! 2008 thesis.

use crate::tempo::BEAT;
use eightfold_tracer::maths::{cos, sin};
use eightfold_tracer::scene::{Camera, Light, Material, Plane, Scene, Sphere};
use glam::{Vec3, vec3};

/// Seconds of one orbit: a full turn at 0.25 radians per second.
pub const MODEL_LENGTH: f32 = 8.0 * core::f32::consts::PI;

const MATT: Material = Material { index: 1.5, ..Material::BLACK };

const PAPER: Material =
    Material { colour: vec3(0.55, 0.55, 0.6), kd: 0.8, ks: 0.1, exponent: 10.0, kr: 0.25, ..MATT };

const RED: Material =
    Material { colour: vec3(0.9, 0.15, 0.12), kd: 0.7, ks: 0.5, exponent: 40.0, kr: 0.25, ..MATT };

const MIRROR: Material =
    Material { colour: vec3(0.9, 0.9, 0.95), kd: 0.2, ks: 0.8, exponent: 80.0, kr: 0.7, ..MATT };

const BLUE: Material =
    Material { colour: vec3(0.15, 0.35, 0.9), kd: 0.7, ks: 0.5, exponent: 40.0, kr: 0.2, ..MATT };

const GLASS: Material = Material {
    colour: vec3(0.95, 0.95, 0.95),
    kd: 0.05,
    ks: 0.8,
    exponent: 100.0,
    kr: 0.1,
    kt: 0.85,
    tint: vec3(0.65 * 0.85, 0.88 * 0.85, 1.1 * 0.85),
    ..MATT
};

/// Sets the model scene at `time` seconds. The camera's path repeats every [`MODEL_LENGTH`].
pub fn model(time: f32, scene: &mut Scene) {
    // The small ball floats up and down.
    let sine = sin(time / BEAT * 0.5);
    let small = vec3(0.6, 0.5 + 0.4 * sine * sine, -1.6);
    *scene = Scene {
        camera: orbit(time, 0.9, 7.5, 1.3),
        background: vec3(0.10, 0.12, 0.20),
        ambient: vec3(0.12, 0.12, 0.14),
        black_beyond: true,
        ..Scene::default()
    };
    scene.planes.push(Plane::new(Vec3::ZERO, 12.0, 12.0, PAPER));
    for (centre, radius, material) in [
        (vec3(-2.2, 1.0, 0.5), 1.0, RED),
        (vec3(0.0, 1.2, 1.8), 1.2, MIRROR),
        (vec3(2.2, 1.0, 0.3), 1.0, BLUE),
        (small, 0.5, GLASS),
    ] {
        scene.spheres.push(Sphere::new(centre, radius, material));
    }
    for (position, colour) in [
        (vec3(-4.0, 6.0, -4.0), vec3(0.90, 0.85, 0.80)),
        (vec3(5.0, 5.0, -2.0), vec3(0.35, 0.40, 0.50)),
    ] {
        scene.lights.push(Light { drawn_radius: 0.15, ..Light::new(position, colour) });
    }
}

/// Returns a camera that orbits the y axis, `distance` units away from it and `above` a point at
/// `height`.
pub(super) fn orbit(time: f32, height: f32, distance: f32, above: f32) -> Camera {
    let angle = 0.25 * time;
    let look_at = vec3(0.0, height, 0.0);
    let away = vec3(distance * sin(angle), above, -distance * cos(angle));
    Camera::new(look_at + away, look_at, core::f32::consts::FRAC_PI_4)
}

/// Returns the scene of [`model`].
#[must_use]
pub fn model_scene(time: f32) -> Scene {
    let mut scene = Scene::default();
    model(time, &mut scene);
    scene
}
