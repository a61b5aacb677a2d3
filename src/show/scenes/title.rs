//! The title: spheres fly in from all around and form a word.

use crate::font::{ADVANCE, strokes};
use crate::maths::{round, smooth_step, sqrt};
use crate::scene::{Scene, Sphere};
use crate::show::act::{Act, Shot, shot};
use crate::show::captions::Line;
use crate::show::material;
use crate::show::path::key;
use crate::show::random::Random;
use crate::show::set::{FAR, Set, point};
use glam::{Vec3A, vec3a};

/// The scene as a record.
pub(in crate::show) const ACT: Act = Act {
    set: &SET,
    set_since: 0,
    shots: SHOTS,
    captions: CAPTIONS,
};

static SET: Set = Set {
    background: vec3a(0.05, 0.07, 0.14),
    sky: vec3a(-0.04, -0.05, -0.08),
    ambient: vec3a(0.10, 0.10, 0.10),
    haze: 0.015,
    floor: &material::NIGHT,
    floor_half: FAR,
    lights: &[
        point([7.0, 8.0, -9.0], [1.25, 0.95, 0.62]),
        point([-9.0, 4.0, -5.0], [0.30, 0.48, 0.95]),
    ],
    flash: 0.0,
    props: &[],
    special: Some(add),
};

#[rustfmt::skip]
static SHOTS: &[Shot] = &[
    shot(6, key([4.0, 1.0, 0.0],   0.9,  9.0, 0.4), key([0.0, 1.2, 0.0], -0.2, 14.6, 1.8)),
];

#[rustfmt::skip]
static CAPTIONS: &[Line] = &[
    Line { first: 12.0, beats: 11.0, middle: 0.82, size: 0.040, text: "RAYS BY SQUARES OF EIGHT" },
];

const WORD: &[u8; 9] = b"EIGHTFOLD";

/// The width of the word, in units of the font's grid.
const WIDTH: f32 = ADVANCE * WORD.len() as f32;
/// The size of a grid unit, in scene units.
const STEP: f32 = 0.5;
/// Spheres per grid unit of a stroke.
const SPHERES: f32 = 2.0;
/// The radius of a sphere, in scene units.
const RADIUS: f32 = 0.125;

/// Beats that a sphere's flight takes.
const FLIGHT: f32 = 6.0;
/// The beat at which the last sphere sets off.
const LAST: f32 = 6.0;

/// The box in which the spheres start: its corner with the smallest coordinates, and its extent, in scene units.
const START: Vec3A = vec3a(-15.0, 4.0, -12.0);
const START_EXTENT: Vec3A = vec3a(30.0, 10.0, 24.0);

/// Adds the spheres as they are `beat` beats after the start of the show.
fn add(beat: f32, scene: &mut Scene) {
    let mut random = Random(8);
    let mut left = 0.0;
    for &letter in WORD {
        for (from, to) in strokes(letter) {
            let way = to - from;
            // Evenly spaced, with a sphere at each end.
            let count = round(sqrt(way.length_squared()) * SPHERES) as i32;
            for i in 0..count + 1 {
                let at = from + way * (i as f32 / count as f32);
                add_sphere(left + at.x, at.y, beat, &mut random, scene);
            }
        }
        left += ADVANCE;
    }
}

/// Adds the sphere that ends up at a point of the word, in grid units to the right of its upper left corner and below it.
fn add_sphere(right: f32, down: f32, beat: f32, random: &mut Random, scene: &mut Scene) {
    let home = vec3a(0.5 * (WIDTH - 1.0) - right, 4.0 - down, 0.0) * STEP;
    let away =
        vec3a(random.fraction(), random.fraction(), random.fraction()) * START_EXTENT + START;
    // They set off from left to right.
    let way = smooth_step((beat - LAST / WIDTH * right) / FLIGHT);
    let centre = away + (home + Vec3A::Y * RADIUS - away) * way;
    scene.spheres.push(Sphere {
        centre,
        radius: RADIUS,
        material: material::GOLD,
    });
}
