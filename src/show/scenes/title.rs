//! The title: golden letters rise out of dark water, one after another, where a light passes.

use crate::show::captions::Cue;
use crate::show::environment::{Environment, FAR, SHOW, point};
use crate::show::material;
use crate::show::path::keyframe;
use crate::show::props::add_rod;
use crate::show::scene::{Shot, ShowScene, shot};
use eightfold_tracer::font::strokes;
use eightfold_tracer::maths::smooth_step;
use eightfold_tracer::scene::{Light, Scene};
use glam::{Vec2, Vec3, vec3};

pub(in crate::show) const SCENE: ShowScene = ShowScene {
    captions: CAPTIONS,
    // The shots show the whole name in 4:3.
    min_aspect: 4.0 / 3.0,
    ..ShowScene::new(&ENVIRONMENT, SHOTS)
};

static ENVIRONMENT: Environment = Environment {
    background: vec3(0.26, 0.18, 0.32),
    sky: vec3(-0.25, -0.16, -0.26),
    ambient: vec3(0.10, 0.10, 0.12),
    haze: 0.02,
    film: SHOW,
    floor: &material::WATER,
    floor_half: FAR,
    swell: 0.006,
    lights: &[
        Light { drawn_radius: 0.12, glow: 0.15, ..point([0.0, 1.1, -1.4], [0.86, 0.69, 0.43]) },
        point([7.0, 8.0, -9.0], [0.67, 0.52, 0.34]),
        point([-9.0, 4.0, -5.0], [0.26, 0.41, 0.81]),
    ],
    kick_response: 0.0,
    props: &[],
    procedural: Some(add),
};

#[rustfmt::skip]
static SHOTS: &[Shot] = &[
    // Move back at the pace of the rising letters, to keep them all in the picture even at 4:3.
    shot(6, &[
        keyframe([6.4, 0.9, 0.0], 0.9, 5.0, 0.1),
        keyframe([4.5, 1.0, 0.0], 0.75, 5.1, 0.05).rolled(-0.03),
        keyframe([2.6, 1.0, 0.0], 0.6, 9.0, 0.15),
        keyframe([0.6, 1.0, 0.0], 0.42, 12.9, 0.4).rolled(0.03),
        keyframe([0.4, 1.0, 0.0], 0.2, 13.1, 0.8).rolled(0.02),
        keyframe([0.1, 1.0, 0.0], 0.0, 13.3, 1.15),
        keyframe([0.0, 1.0, 0.0], -0.15, 13.4, 1.3),
    ]),
];

#[rustfmt::skip]
static CAPTIONS: &[Cue] = &[
    Cue { first: 17.0, beats: 7.0, middle: 0.16, size: 0.045, text: "RAYS BY SQUARES OF EIGHT" },
];

const WORD: &[u8; 9] = b"EIGHTFOLD";

/// The distance between neighbouring letters, in units of the font's grid.
const ADVANCE: f32 = 3.0;
const WIDTH: f32 = ADVANCE * WORD.len() as f32 - 1.0;
/// A grid unit in scene units.
const STEP: f32 = 0.5;
/// Half the width of a letter's first stroke, in scene units.
const RADIUS: f32 = 0.15;
/// A stroke's width relative to the previous one, which hides the end of a bar in its stem: with equal widths, rounding would select
/// one of two coincident surfaces.
const NARROWER: f32 = 0.99;

const BEATS: f32 = 1.5;
const RISE: f32 = 3.0;
/// The height of the rise in grid units, slightly more than a letter's.
const DEPTH: f32 = 5.0;

fn add(beat: f32, scene: &mut Scene) {
    // The light passes half-risen letters; the first one is already rising when the show begins.
    let beat = beat + 1.0;
    scene.lights[0].position.x = STEP * (0.5 * WIDTH + ADVANCE - ADVANCE / BEATS * beat);
    for (number, &letter) in (0..).zip(WORD) {
        let number = number as f32;
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
