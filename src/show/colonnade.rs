//! The colonnade: a low sun through two rows of columns, and balls of glass and metal between them.

use super::material::{GLASS, MARBLE, metal, plastic, tiles};
use super::path::{Key, between};
use crate::scene::{Block, Light, List, Material, Plane, Scene, Sphere, Spot};
use crate::trigonometry::sin;
use glam::{Vec3A, vec3a};

/// Columns of a row.
const COLUMNS: usize = 7;
/// Between two columns of a row.
const GAP: f32 = 3.2;

/// What a column is made of, from the floor up: height of the middle, half sizes, round.
static PARTS: [(f32, Vec3A, bool); 4] = [
    (0.15, vec3a(0.75, 0.15, 0.75), false),
    (0.40, vec3a(0.62, 0.10, 0.62), true),
    (2.65, vec3a(0.45, 2.15, 0.45), true),
    (4.95, vec3a(0.70, 0.15, 0.70), false),
];

static LIGHTS: [Light; 3] = [
    // The sun.
    Light {
        position: vec3a(70.0, 42.0, -34.0),
        colour: vec3a(1.0, 0.70, 0.40),
        parallel: true,
        size: 2.0,
        ..Light::DARK
    },
    // The sky.
    Light {
        position: vec3a(-40.0, 50.0, -50.0),
        colour: vec3a(0.16, 0.22, 0.38),
        parallel: true,
        ..Light::DARK
    },
    // From above on what floats in the middle.
    Light {
        position: vec3a(0.0, 9.0, 6.0),
        colour: vec3a(0.45, 0.50, 0.65),
        size: 1.2,
        spot: Some(Spot {
            aim: vec3a(0.0, -1.0, 0.0),
            dark: 0.955,
            bright: 0.985,
        }),
        ..Light::DARK
    },
];

static WAY: [Key; 2] = [
    Key {
        look_at: vec3a(-0.4, 1.6, -3.0),
        angle: -0.35,
        distance: 9.0,
        height: 0.1,
    },
    Key {
        look_at: vec3a(0.3, 1.9, 5.0),
        angle: 0.30,
        distance: 7.0,
        height: 1.4,
    },
];

/// At a share `u` of the scene's length.
pub(super) fn scene(u: f32, beat: f32) -> Scene {
    let mut blocks = List::default();
    for i in 0..2 * COLUMNS {
        let x = if i % 2 == 0 { -2.6 } else { 2.6 };
        let z = GAP * (i / 2) as f32 - 6.0;
        for (y, half, round) in PARTS {
            blocks.push(Block {
                centre: vec3a(x, y, z),
                half,
                round,
                material: MARBLE,
                ..Block::default()
            });
        }
    }
    for x in [-2.6, 2.6] {
        blocks.push(Block {
            centre: vec3a(x, 5.45, 3.0),
            half: vec3a(0.55, 0.35, 0.5 * GAP * COLUMNS as f32),
            material: MARBLE,
            ..Block::default()
        });
    }
    let float = |phase: f32| 0.15 * sin(0.8 * beat + phase);
    let ball = |x: f32, y: f32, z: f32, radius: f32, material: Material| Sphere {
        centre: vec3a(x, y + float(z), z),
        radius,
        material,
    };
    Scene {
        camera: between(&WAY[0], &WAY[1], u),
        background: vec3a(0.78, 0.50, 0.36),
        sky: vec3a(-0.62, -0.26, 0.10),
        haze: 0.022,
        ambient: vec3a(0.16, 0.15, 0.20),
        spheres: List::of(&[
            ball(0.0, 1.9, 6.0, 0.9, GLASS),
            ball(-0.9, 0.9, 1.4, 0.5, metal(vec3a(0.95, 0.70, 0.38))),
            ball(0.9, 1.2, 3.2, 0.45, plastic(vec3a(0.75, 0.12, 0.10))),
            ball(-0.2, 3.4, 9.0, 0.7, metal(vec3a(0.85, 0.88, 0.95))),
        ]),
        planes: List::of(&[Plane {
            half_x: 60.0,
            half_z: 60.0,
            material: tiles(vec3a(0.62, 0.52, 0.44), 1.3, 0.22),
            ..Plane::default()
        }]),
        blocks,
        lights: List::of(&LIGHTS),
        ..Scene::default()
    }
}
