//! The finale: a glass ball at dusk, behind the names.

use super::material::{GLASS, metal, plastic};
use super::path::{Key, between, smooth};
use crate::scene::{Light, List, Material, Plane, Scene, Sphere};
use crate::trigonometry::{cos, sin};
use core::f32::consts::TAU;
use glam::vec3a;

/// Balls that circle.
const BALLS: usize = 8;

static LIGHTS: [Light; 2] = [
    Light {
        position: vec3a(40.0, 22.0, 60.0),
        colour: vec3a(0.85, 0.50, 0.28),
        parallel: true,
        size: 3.0,
        ..Light::DARK
    },
    Light {
        position: vec3a(-6.0, 8.0, -8.0),
        colour: vec3a(0.30, 0.36, 0.55),
        ..Light::DARK
    },
];

static WAY: [Key; 2] = [
    Key {
        look_at: vec3a(0.0, 1.9, 0.0),
        angle: -0.3,
        distance: 9.0,
        height: 0.2,
    },
    Key {
        look_at: vec3a(0.0, 2.6, 0.0),
        angle: 0.3,
        distance: 15.0,
        height: 1.6,
    },
];

/// At a share `u` of the scene's length.
pub(super) fn scene(u: f32, beat: f32) -> Scene {
    let mut spheres = List::of(&[Sphere {
        centre: vec3a(0.0, 1.3, 0.0),
        radius: 1.3,
        material: GLASS,
    }]);
    for i in 0..BALLS {
        let turn = TAU * i as f32 / BALLS as f32 + 0.12 * beat;
        spheres.push(Sphere {
            centre: vec3a(3.2 * sin(turn), 0.4, 3.2 * cos(turn)),
            radius: 0.4,
            material: if i % 2 == 0 {
                metal(vec3a(0.98, 0.75, 0.40))
            } else {
                plastic(vec3a(0.80, 0.12, 0.10))
            },
        });
    }
    Scene {
        camera: between(&WAY[0], &WAY[1], u),
        background: vec3a(0.55, 0.30, 0.22),
        sky: vec3a(-0.52, -0.24, -0.06),
        haze: 0.03,
        fade: smooth(u * 6.0 - 5.0),
        ambient: vec3a(0.12, 0.11, 0.16),
        spheres,
        planes: List::of(&[Plane {
            half_x: 60.0,
            half_z: 60.0,
            material: Material {
                colour: vec3a(0.20, 0.19, 0.24),
                kd: 0.8,
                ks: 0.2,
                exponent: 20.0,
                kr: 0.45,
                ..Material::BLACK
            },
            ..Plane::default()
        }]),
        lights: List::of(&LIGHTS),
        ..Scene::default()
    }
}
