//! A sphereflake: a sphere with five of half its size on it, each of these with four or five, and so on.
//!
//! After Eric Haines' sphereflake of 1987, a benchmark of ray tracers since.

use crate::show::environment::{Environment, FAR, SHOW, point};
use crate::show::material;
use crate::show::path::keyframe;
use crate::show::props::add_sphere;
use crate::show::scene::{Shot, ShowScene, shot};
use eightfold_tracer::maths::smooth_step;
use eightfold_tracer::scene::{Light, Material, Scene};
use glam::{Vec3, vec3};

pub(in crate::show) const SCENE: ShowScene = ShowScene::new(&ENVIRONMENT, SHOTS);

static ENVIRONMENT: Environment = Environment {
    background: vec3(0.84, 0.76, 0.72),
    sky: vec3(-0.70, -0.44, -0.10),
    ambient: vec3(0.22, 0.24, 0.30),
    haze: 0.025,
    film: SHOW,
    floor: &material::PAPER,
    floor_half: FAR,
    swell: 0.0,
    lights: &[
        Light { diameter: 0.9, ..point([6.0, 9.0, -5.0], [0.95, 0.80, 0.62]) },
        point([-8.0, 3.0, -2.0], [0.20, 0.34, 0.62]),
    ],
    kick_response: 1.0,
    props: &[],
    procedural: Some(add),
};

#[rustfmt::skip]
static SHOTS: &[Shot] = &[
    shot(4, &[
        keyframe([0.0, 1.5, 0.0], 0.9, 5.4, -0.4),
        keyframe([0.0, 1.6, 0.0], 0.4, 6.0, 0.2).rolled(0.04),
        keyframe([0.0, 1.7, 0.0], -0.3, 6.6, 1.2).rolled(0.04),
        keyframe([0.0, 1.7, 0.0], -1.1, 6.8, 2.4),
    ]),
    shot(2, &[
        keyframe([0.3, 1.8, -0.5], 0.5, 4.2, 1.0).rolled(-0.06),
        keyframe([0.2, 1.8, -0.3], 0.1, 5.0, 0.7),
        keyframe([0.0, 1.9, 0.0], -0.3, 7.8, 0.3),
    ]),
];

/// The radius of the first sphere; each generation halves it.
const RADIUS: f32 = 1.1;
const GENERATIONS: u8 = 3;
/// The beats between generations: each grows on a bar, within a beat.
const BEATS: f32 = 4.0;

/// The colour of the first sphere, and the change per generation: from silver to orange.
const SILVER: Vec3 = vec3(0.78, 0.80, 0.90);
const TO_ORANGE: Vec3 = vec3(0.05, -0.15, -0.27);

fn add(beat: f32, scene: &mut Scene) {
    add_flake(Vec3::Y * RADIUS, RADIUS, Vec3::ZERO, 0, beat, scene);
}

/// Adds a sphere and its descendants: one in each axis direction except down, and except `back`, towards its parent.
fn add_flake(centre: Vec3, radius: f32, back: Vec3, generation: u8, beat: f32, scene: &mut Scene) {
    let number = f32::from(generation);
    let material = Material {
        colour: SILVER + TO_ORANGE * number,
        kd: 0.25 + 0.18 * number,
        kr: f32::max(0.5 - 0.25 * number, 0.0),
        ..material::RED
    };
    add_sphere(centre, radius, &material, scene);
    let grown = smooth_step(beat - BEATS * (number + 1.0));
    if generation == GENERATIONS || grown == 0.0 {
        return;
    }
    let radius_on = 0.5 * radius * grown;
    for out in [Vec3::X, Vec3::Y, Vec3::Z, -Vec3::X, -Vec3::Z] {
        if out != back {
            let centre = centre + out * (radius + radius_on);
            add_flake(centre, radius_on, -out, generation + 1, beat, scene);
        }
    }
}
