//! The title: spheres come from everywhere and form a word.

use super::letters::{self, ADVANCE};
use super::material::metal;
use super::path::{Key, between, smooth};
use super::random::Random;
use crate::scene::{Light, List, Material, Plane, Scene, Sphere};
use glam::{Vec3A, vec3a};

const WORD: &str = "EIGHTFOLD";

/// Scene units of a step of the letters' grid.
const STEP: f32 = 0.5;
/// Spheres to a step.
const SPHERES: f32 = 2.0;
const RADIUS: f32 = 0.125;

static LIGHTS: [Light; 2] = [
    Light {
        position: vec3a(7.0, 8.0, -9.0),
        colour: vec3a(1.25, 0.95, 0.62),
        ..Light::DARK
    },
    Light {
        position: vec3a(-9.0, 4.0, -5.0),
        colour: vec3a(0.30, 0.48, 0.95),
        ..Light::DARK
    },
];

static WAY: [Key; 2] = [
    Key {
        look_at: vec3a(4.0, 1.0, 0.0),
        angle: 0.9,
        distance: 9.0,
        height: 0.4,
    },
    Key {
        look_at: vec3a(0.0, 1.2, 0.0),
        angle: -0.15,
        distance: 14.5,
        height: 1.8,
    },
];

/// At a share `u` of the scene's length.
pub(super) fn scene(u: f32) -> Scene {
    let mut random = Random(8);
    let mut spheres = List::default();
    let left = 0.5 * STEP * (ADVANCE * WORD.len() as f32 - 1.0);
    letters::strokes(WORD, |from, to| {
        let count = (from.distance(to) * SPHERES + 0.5) as usize;
        for i in 0..=count {
            let at = from + (to - from) * (i as f32 / count as f32);
            let home = vec3a(left - at.x * STEP, (4.0 - at.y) * STEP + RADIUS, 0.0);
            let mut chance = || random.share() - 0.5;
            let away = vec3a(30.0 * chance(), 9.0 + 10.0 * chance(), 24.0 * chance());
            // One after the other from the left, and all there at half time.
            let start = 0.25 * (at.x / (ADVANCE * WORD.len() as f32));
            let way = smooth((u - start) * 4.0);
            spheres.push(Sphere {
                centre: away + (home - away) * way,
                radius: RADIUS,
                material: metal(vec3a(1.0, 0.78, 0.45)),
            });
        }
    });
    Scene {
        camera: between(&WAY[0], &WAY[1], smooth(u)),
        background: vec3a(0.05, 0.07, 0.14),
        sky: vec3a(-0.04, -0.05, -0.08),
        haze: 0.015,
        fade: 1.0 - smooth(u * 12.0),
        ambient: Vec3A::splat(0.10),
        spheres,
        planes: List::of(&[Plane {
            half_x: 60.0,
            half_z: 60.0,
            material: Material {
                colour: vec3a(0.16, 0.18, 0.26),
                kd: 0.7,
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
