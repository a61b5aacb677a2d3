//! The title: spheres fly in from all around and form a word.

use super::material;
use super::random::Random;
use crate::font::{ADVANCE, strokes};
use crate::maths::{round, smooth_step, sqrt};
use crate::scene::{Scene, Sphere};
use glam::{Vec3A, vec3a};

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
pub(super) fn add(beat: f32, scene: &mut Scene) {
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
