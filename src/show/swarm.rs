//! The field: 256 spheres that wave, curl to a ball and run along a figure of eight.

use super::material::{metal, plastic};
use super::path::{Key, between, smooth};
use crate::scene::{Light, List, Material, Plane, Scene, Sphere};
use crate::trigonometry::{cos, sin};
use core::f32::consts::TAU;
use glam::{Vec3A, vec3a};

/// Spheres along a side of the square they start from.
const SIDE: usize = 16;

static LIGHTS: [Light; 2] = [
    Light {
        position: vec3a(-8.0, 12.0, -6.0),
        colour: vec3a(1.0, 0.86, 0.70),
        size: 1.5,
        ..Light::DARK
    },
    Light {
        position: vec3a(10.0, 6.0, 4.0),
        colour: vec3a(0.16, 0.26, 0.55),
        ..Light::DARK
    },
];

static WAY: [Key; 2] = [
    Key {
        look_at: vec3a(0.0, 0.8, 0.0),
        angle: 0.6,
        distance: 12.0,
        height: 5.5,
    },
    Key {
        look_at: vec3a(0.0, 2.4, 0.0),
        angle: -3.0,
        distance: 9.5,
        height: 2.6,
    },
];

/// At a share `u` of the scene's length.
pub(super) fn scene(u: f32, beat: f32) -> Scene {
    let mut spheres = List::default();
    let to_ball = smooth(u * 6.0 - 1.5);
    let to_eight = smooth(u * 6.0 - 3.5);
    for i in 0..SIDE * SIDE {
        let (column, row) = ((i % SIDE) as f32 - 7.5, (i / SIDE) as f32 - 7.5);
        let far = column * column + row * row;
        let wave = sin(0.06 * far - TAU * 0.25 * beat);
        let flat = vec3a(0.75 * column, 0.9 + 0.55 * wave, 0.75 * row);
        // A ball of turns about its axis, by the golden angle.
        let n = (i as f32 + 0.5) / (SIDE * SIDE) as f32;
        let turn = 2.4 * i as f32 + 0.3 * beat;
        let y = 1.0 - 2.0 * n;
        let across = libm::sqrtf(1.0 - y * y);
        let swell = 2.3 + 0.15 * sin(TAU * 0.5 * beat);
        let ball = vec3a(across * cos(turn), y, across * sin(turn)) * swell + vec3a(0.0, 2.7, 0.0);
        // A cord along an upright eight.
        let along = TAU * n + 0.2 * beat;
        let twist = 12.0 * along + beat;
        let eight = vec3a(
            1.7 * sin(2.0 * along) + 0.45 * cos(twist),
            2.8 + 2.2 * cos(along) + 0.45 * sin(twist),
            0.5 * sin(along),
        );
        let centre = flat + (ball - flat) * to_ball;
        let centre = centre + (eight - centre) * to_eight;
        spheres.push(Sphere {
            centre,
            radius: 0.24 - 0.05 * to_ball,
            material: colour(n, wave),
        });
    }
    Scene {
        camera: between(&WAY[0], &WAY[1], u),
        background: vec3a(0.10, 0.12, 0.20),
        sky: vec3a(-0.08, -0.09, -0.12),
        haze: 0.03,
        ambient: vec3a(0.12, 0.12, 0.15),
        spheres,
        planes: List::of(&[Plane {
            half_x: 60.0,
            half_z: 60.0,
            material: Material {
                colour: vec3a(0.22, 0.24, 0.34),
                kd: 0.8,
                ks: 0.1,
                exponent: 20.0,
                kr: 0.35,
                ..Material::BLACK
            },
            ..Plane::default()
        }]),
        lights: List::of(&LIGHTS),
        ..Scene::default()
    }
}

/// From red over gold to blue.
fn colour(n: f32, wave: f32) -> Material {
    let warm = vec3a(0.90, 0.15, 0.10);
    let cold = vec3a(0.12, 0.32, 0.90);
    let mixed: Vec3A = warm + (cold - warm) * smooth(n);
    if wave > 0.6 {
        metal(vec3a(0.98, 0.75, 0.40))
    } else {
        plastic(mixed)
    }
}
