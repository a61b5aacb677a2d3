//! The machine: pistons that strike on every beat, and what they drive.

use super::material::{metal, plastic, tiles};
use super::path::{Key, between, smooth};
use crate::scene::{Block, Light, List, Material, Pattern, Plane, Scene, Sphere, Spot};
use crate::trigonometry::{cos, sin};
use core::f32::consts::{PI, TAU};
use glam::{Mat3A, Vec3A, vec3a};

const STEEL: Material = metal(vec3a(0.55, 0.62, 0.75));
const BRASS: Material = metal(vec3a(0.95, 0.68, 0.30));
const RED: Material = plastic(vec3a(0.80, 0.10, 0.07));

static LIGHTS: [Light; 3] = [
    Light {
        position: vec3a(-5.0, 9.0, -6.0),
        colour: vec3a(1.25, 1.05, 0.82),
        size: 0.8,
        spot: Some(Spot {
            aim: vec3a(0.41916, -0.75848, 0.49900),
            dark: 0.70,
            bright: 0.95,
        }),
        ..Light::DARK
    },
    Light {
        position: vec3a(7.0, 5.0, 2.0),
        colour: vec3a(0.35, 0.50, 0.95),
        radius: 0.2,
        ..Light::DARK
    },
    Light {
        position: vec3a(0.0, 2.2, 7.0),
        colour: vec3a(0.60, 0.16, 0.08),
        ..Light::DARK
    },
];

static WAY: [Key; 2] = [
    Key {
        look_at: vec3a(-1.0, 1.6, 0.0),
        angle: -0.9,
        distance: 7.0,
        height: 0.8,
    },
    Key {
        look_at: vec3a(0.0, 1.7, 0.0),
        angle: 0.8,
        distance: 9.5,
        height: 2.6,
    },
];

/// Turned about the z axis.
fn turned(angle: f32) -> Mat3A {
    let (s, c) = (sin(angle), cos(angle));
    Mat3A::from_cols(Vec3A::new(c, s, 0.0), Vec3A::new(-s, c, 0.0), Vec3A::Z)
}

/// On its side: its own y axis along z.
const LYING: Mat3A = Mat3A::from_cols(Vec3A::X, Vec3A::Z, Vec3A::NEG_Y);

/// At a share `u` of the scene's length.
pub(super) fn scene(u: f32, beat: f32) -> Scene {
    let mut blocks = List::default();
    let mut add = |centre: Vec3A, half: Vec3A, axes: Mat3A, round: bool, material: Material| {
        blocks.push(Block {
            centre,
            half,
            axes,
            round,
            material,
        });
    };
    // A turn in four beats, in jerks.
    let whole = (beat as i32) as f32;
    let angle = TAU * 0.25 * (whole + smooth((beat - whole) * 1.6));
    // The axle, its wheel with spokes, and rims of boxes.
    let hub = vec3a(0.0, 2.2, 1.2);
    add(hub, vec3a(0.22, 2.6, 0.22), LYING, true, STEEL);
    add(hub, vec3a(0.55, 0.30, 0.55), LYING, true, BRASS);
    for i in 0..8 {
        let turn = angle + i as f32 * 0.25 * PI;
        let out = vec3a(-sin(turn), cos(turn), 0.0);
        add(
            hub + 1.0 * out,
            vec3a(0.09, 0.85, 0.09),
            turned(turn),
            false,
            STEEL,
        );
        add(
            hub + 1.85 * out,
            vec3a(0.62, 0.16, 0.32),
            turned(turn),
            false,
            if i % 2 == 0 { RED } else { BRASS },
        );
    }
    // Four pistons in front: each strikes on its own beat of the bar.
    for i in 0..4 {
        let x = 1.5 * i as f32 - 2.25;
        let since = beat + 4.0 - i as f32;
        let since = since - 4.0 * (((since * 0.25) as i32) as f32);
        // Down at once, up in three beats.
        let lift = smooth(since / 3.0) - smooth((since - 3.75) * 4.0);
        let y = 0.85 + 0.9 * lift;
        add(
            vec3a(x, 0.25, -1.6),
            vec3a(0.55, 0.25, 0.55),
            Mat3A::IDENTITY,
            false,
            STEEL,
        );
        add(
            vec3a(x, y, -1.6),
            vec3a(0.42, 0.35, 0.42),
            Mat3A::IDENTITY,
            true,
            BRASS,
        );
        add(
            vec3a(x, y + 1.3, -1.6),
            vec3a(0.13, 1.0, 0.13),
            Mat3A::IDENTITY,
            true,
            STEEL,
        );
    }
    // The frame behind it all.
    for x in [-3.4, 3.4] {
        add(
            vec3a(x, 2.0, 1.2),
            vec3a(0.35, 2.0, 0.6),
            Mat3A::IDENTITY,
            false,
            Material {
                pattern: Pattern {
                    waves: vec3a(0.0, 1.0, 0.0),
                    depth: 0.7,
                    edge: 30.0,
                    ..Pattern::NONE
                },
                ..plastic(vec3a(0.90, 0.62, 0.10))
            },
        );
    }
    Scene {
        camera: between(&WAY[0], &WAY[1], u),
        background: vec3a(0.06, 0.07, 0.11),
        sky: vec3a(-0.03, -0.03, -0.03),
        haze: 0.03,
        ambient: vec3a(0.10, 0.11, 0.15),
        spheres: List::of(&[
            Sphere {
                centre: vec3a(-3.4, 4.5, 1.2),
                radius: 0.5,
                material: BRASS,
            },
            Sphere {
                centre: vec3a(3.4, 4.5, 1.2),
                radius: 0.5,
                material: BRASS,
            },
        ]),
        planes: List::of(&[Plane {
            half_x: 60.0,
            half_z: 60.0,
            material: tiles(vec3a(0.62, 0.62, 0.66), 0.9, 0.25),
            ..Plane::default()
        }]),
        blocks,
        lights: List::of(&LIGHTS),
        ..Scene::default()
    }
}
