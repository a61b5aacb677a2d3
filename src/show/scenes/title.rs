//! The title: letters of gold rise out of dark water, one after another, where a lamp passes.

use crate::show::act::{Act, Shot, shot};
use crate::show::captions::Line;
use crate::show::material;
use crate::show::path::key;
use crate::show::props::add_rod;
use crate::show::set::{FAR, SHOW, Set, point};
use eightfold_tracer::font::strokes;
use eightfold_tracer::maths::smooth_step;
use eightfold_tracer::scene::{Light, Scene};
use glam::{Vec2, Vec3, vec3};

/// The scene as a record.
pub(in crate::show) const ACT: Act = Act {
    captions: CAPTIONS,
    ..Act::new(&SET, SHOTS)
};

static SET: Set = Set {
    background: vec3(0.26, 0.18, 0.32),
    sky: vec3(-0.25, -0.16, -0.26),
    ambient: vec3(0.10, 0.10, 0.12),
    haze: 0.02,
    film: SHOW,
    floor: &material::WATER,
    floor_half: FAR,
    swell: 0.015,
    lights: &[
        // The lamp, see `add`.
        Light {
            drawn_radius: 0.12,
            glow: 0.15,
            ..point([0.0, 1.1, -1.4], [0.86, 0.69, 0.43])
        },
        point([7.0, 8.0, -9.0], [0.67, 0.52, 0.34]),
        point([-9.0, 4.0, -5.0], [0.26, 0.41, 0.81]),
    ],
    hit: 0.0,
    props: &[],
    special: Some(add),
};

#[rustfmt::skip]
static SHOTS: &[Shot] = &[
    // Back as fast as letters rise, so that all are in the picture, also where it is no wider than 4:3, and past them.
    shot(6, &[
        key([6.4, 0.9, 0.0], 0.9, 5.0, 0.1),
        key([4.5, 1.0, 0.0], 0.75, 5.1, 0.05).rolled(-0.03),
        key([2.6, 1.0, 0.0], 0.6, 9.0, 0.15),
        key([0.6, 1.0, 0.0], 0.42, 12.9, 0.4).rolled(0.03),
        key([0.4, 1.0, 0.0], 0.2, 13.1, 0.8).rolled(0.02),
        key([0.1, 1.0, 0.0], 0.0, 13.3, 1.15),
        key([0.0, 1.0, 0.0], -0.15, 13.4, 1.3),
    ]),
];

#[rustfmt::skip]
static CAPTIONS: &[Line] = &[
    Line { first: 17.0, beats: 7.0, middle: 0.16, size: 0.045, text: "RAYS BY SQUARES OF EIGHT" },
];

const WORD: &[u8; 9] = b"EIGHTFOLD";

/// The distance between the left sides of neighbouring letters, in units of the font's grid.
const ADVANCE: f32 = 3.0;
/// The width of the word, in the same units.
const WIDTH: f32 = ADVANCE * WORD.len() as f32 - 1.0;
/// The size of a grid unit, in scene units.
const STEP: f32 = 0.5;
/// Half the width of a letter's first stroke, in scene units.
const RADIUS: f32 = 0.15;
/// A stroke's width, as a share of that of the one before. So the end of a bar is hidden in the stem that it meets: were both as wide,
/// rounding would decide which of two surfaces in one place is seen.
const NARROWER: f32 = 0.99;

/// The beats from one letter to the next.
const BEATS: f32 = 1.5;
/// The beats that a letter takes to rise.
const RISE: f32 = 3.0;
/// How far it rises, in grid units: a little more than its height.
const DEPTH: f32 = 5.0;

/// Adds the letters, and moves the lamp, `beat` beats after the start of the show.
fn add(beat: f32, scene: &mut Scene) {
    // It passes a letter that has half risen; the first one is rising when the show begins.
    let beat = beat + 1.0;
    scene.lights[0].position.x = STEP * (0.5 * WIDTH + ADVANCE - ADVANCE / BEATS * beat);
    for (number, &letter) in (0..).zip(WORD) {
        let number = number as f32;
        // How far it has yet to rise, in grid units.
        let below = DEPTH * (1.0 - smooth_step((beat - BEATS * number) / RISE));
        let place = |on_grid: Vec2| {
            let right = ADVANCE * number + on_grid.x;
            let up = 4.0 - on_grid.y - below;
            vec3(0.5 * WIDTH - right, up, 0.0) * STEP + Vec3::Y * RADIUS
        };
        let mut radius = RADIUS;
        for (from, to) in strokes(letter) {
            let ends = [place(from), place(to)];
            add_rod(ends, Vec3::Z, radius, &material::BRASS, scene);
            radius *= NARROWER;
        }
    }
}
