//! The swarm: 256 spheres that undulate in a square, then fly into a ball, and on into a figure of eight.

use crate::show::environment::{Environment, FAR, SHOW, point};
use crate::show::material;
use crate::show::path::keyframe;
use crate::show::props::around;
use crate::show::scene::{Shot, ShowScene, shot};
use core::f32::consts::TAU;
use eightfold_tracer::maths::{cos, sin, smooth_step, sqrt};
use eightfold_tracer::scene::{CopperBar, Light, Material, Scene, Sphere};
use glam::{Vec3, vec3};

pub(in crate::show) const SCENE: ShowScene = ShowScene::new(&ENVIRONMENT, SHOTS);

static ENVIRONMENT: Environment = Environment {
    background: vec3(0.15, 0.38, 0.55),
    sky: vec3(-0.12, -0.33, -0.34),
    ambient: vec3(0.08, 0.08, 0.11),
    haze: 0.03,
    film: SHOW,
    floor: &material::NIGHT,
    floor_half: FAR,
    swell: 0.0,
    lights: &[
        point([-8.0, 12.0, -7.5], [0.95, 0.86, 0.74]),
        Light { drawn_radius: 0.3, glow: 0.5, ..point(MIDDLE.to_array(), [1.00, 0.75, 0.45]) },
    ],
    kick_response: 1.0,
    props: &[],
    procedural: Some(add),
};

#[rustfmt::skip]
static SHOTS: &[Shot] = &[
    shot(3, &[
        keyframe([0.0, 0.8, 0.0], 0.7, 12.8, 4.6),
        keyframe([0.0, 1.0, 0.0], 0.1, 12.4, 4.0).rolled(0.05),
        keyframe([0.0, 1.6, 0.0], -0.5, 10.4, 3.0).rolled(0.05),
        keyframe([0.0, 2.0, 0.0], -1.2, 9.6, 3.0),
    ]),
    shot(3, &[
        keyframe([0.0, 2.6, 0.0], -1.2, 8.0, 0.4),
        keyframe([0.0, 2.6, 0.0], -0.6, 8.0, -0.6).rolled(-0.04),
        keyframe([0.0, 2.6, 0.0], 0.4, 9.0, 0.4),
    ]),
];

const SIDE: i32 = 16;
const COUNT: i32 = SIDE * SIDE;
/// Spheres across the band of the figure of eight.
const WIDE: i32 = 4;

/// The centre of the ball and of the figure of eight, in scene units.
const MIDDLE: Vec3 = vec3(0.0, 2.75, 0.0);

/// The colour of the first sphere, and the change to the last: from red to blue.
const RED: Vec3 = vec3(0.90, 0.15, 0.10);
const TO_BLUE: Vec3 = vec3(-0.78, 0.17, 0.80);
/// The colour of the waves' crests: darker than [`material::GOLD`], because plastic has a larger diffuse coefficient.
const GOLD: Vec3 = vec3(0.85, 0.62, 0.30);

fn add(beat: f32, scene: &mut Scene) {
    for i in 0..COUNT {
        scene.spheres.push(sphere(i, beat));
    }
    add_copper_bars(beat, scene);
}

/// Adds copper bars along the upper and lower border in the bar before the last; they flash with its kicks.
fn add_copper_bars(beat: f32, scene: &mut Scene) {
    if !(16.0..20.0).contains(&beat) {
        return;
    }
    for middle in [1.0 / 64.0, 63.0 / 64.0] {
        scene.copper_bars.push(CopperBar {
            middle,
            height: 1.0 / 32.0,
            colour: GOLD,
            brightness: 1.0,
        });
    }
}

fn sphere(i: i32, beat: f32) -> Sphere {
    let middle = (SIDE - 1) as f32 * 0.5;
    let (column, row) = ((i % SIDE) as f32 - middle, (i / SIDE) as f32 - middle);
    let flat = vec3(column, 0.0, row) * 0.56;
    let wave = sin(0.17 * flat.length_squared() - TAU * 0.25 * beat);
    let flat = flat + Vec3::Y * (0.9 + 0.55 * wave);
    // The ball: a spiral from pole to pole in golden angles.
    let n = (i as f32 + 0.5) / COUNT as f32;
    let y = 1.0 - 2.0 * n;
    let out = around(0.382 * i as f32 + 0.05 * beat) * sqrt(1.0 - y * y);
    let ball = (out + Vec3::Y * y) * 2.4 + MIDDLE;
    // The band passes 1.2 units in front of its centre and 1.2 behind, so that it does not intersect itself.
    let along = (i / WIDE) as f32 * (TAU * WIDE as f32 / COUNT as f32) + 0.2 * beat;
    let across = (i % WIDE) as f32 * 0.36 - 0.54 + 1.2 * sin(along);
    let eight = vec3(1.4 * sin(2.0 * along), 2.3 * cos(along), across) + MIDDLE;
    // A flight takes 1 / 0.3 beats, and the last sphere starts 1.3 flights after the first.
    let to_ball = smooth_step(0.3 * beat - 1.0 - 1.3 * n);
    let to_eight = smooth_step(0.3 * beat - 4.0 - 1.3 * n);
    let centre = flat.lerp(ball, to_ball).lerp(eight, to_eight);
    let radius = 0.24 - 0.05 * to_ball - 0.07 * to_eight;
    let plastic = RED + TO_BLUE * smooth_step(n);
    let gold = smooth_step((wave - 0.75) * 5.0);
    Sphere {
        centre,
        radius,
        material: Material {
            colour: plastic.lerp(GOLD, gold),
            ks: 0.6,
            exponent: 40.0,
            ..material::SCARLET
        },
    }
}
