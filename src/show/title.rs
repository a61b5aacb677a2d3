//! The title: spheres come from everywhere and form a word.

use super::material;
use super::random::Random;
use crate::font::{ADVANCE, strokes};
use crate::maths::{round, smooth_step, sqrt};
use crate::scene::{Scene, Sphere};
use glam::{Vec3A, vec3a};

const WORD: &[u8; 9] = b"EIGHTFOLD";

/// Grid units of the word.
const WIDTH: f32 = ADVANCE * WORD.len() as f32;
/// Scene units of a step of the letters' grid.
const STEP: f32 = 0.5;
/// Spheres to a step.
const SPHERES: f32 = 2.0;
const RADIUS: f32 = 0.125;

/// Beats in which a sphere comes to its place, and after which the last one sets out.
const WAY: f32 = 6.0;
const LAST: f32 = 6.0;

/// Where spheres come from: the least corner of a box, and its sides.
const FIRST: Vec3A = vec3a(-15.0, 4.0, -12.0);
const AWAY: Vec3A = vec3a(30.0, 10.0, 24.0);

/// Adds the spheres as they are so many beats after the scene's begin.
pub(super) fn add(beat: f32, scene: &mut Scene) {
    let mut random = Random(8);
    let mut left = 0.0;
    for &letter in WORD {
        for (from, to) in strokes(letter) {
            let way = to - from;
            // Evenly, with one at each end.
            let count = round(sqrt(way.length_squared()) * SPHERES) as i32;
            for i in 0..count + 1 {
                let at = from + way * (i as f32 / count as f32);
                place(left + at.x, at.y, beat, &mut random, scene);
            }
        }
        left += ADVANCE;
    }
}

/// Adds the sphere of a place in the word, grid units from its upper left.
fn place(right: f32, down: f32, beat: f32, random: &mut Random, scene: &mut Scene) {
    let home = vec3a(0.5 * (WIDTH - 1.0) - right, 4.0 - down, 0.0) * STEP;
    let away = vec3a(random.share(), random.share(), random.share()) * AWAY + FIRST;
    // One after the other from the left.
    let way = smooth_step((beat - LAST / WIDTH * right) / WAY);
    let centre = away + (home + Vec3A::Y * RADIUS - away) * way;
    scene.spheres.push(Sphere {
        centre,
        radius: RADIUS,
        material: material::GOLD,
    });
}
