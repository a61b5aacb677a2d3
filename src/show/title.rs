//! The title: spheres come from everywhere and form a word.

use super::letters::{ADVANCE, strokes};
use super::material::Stuff;
use super::path::smooth;
use super::random::Random;
use super::things::sphere;
use crate::scene::Scene;
use glam::Vec3A;

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

/// Adds the spheres as they are so many beats after the scene's begin.
pub(super) fn add(beat: f32, scene: &mut Scene) {
    let mut random = Random(8);
    for (place, &letter) in WORD.iter().enumerate() {
        for (from, to) in strokes(letter) {
            let count = (from.distance(to) * SPHERES + 0.5) as i32;
            for i in 0..=count {
                let at = from + (to - from) * (i as f32 / count as f32);
                let right = at.x + place as i32 as f32 * ADVANCE;
                let home = Vec3A::new(
                    (0.5 * (WIDTH - 1.0) - right) * STEP,
                    (4.0 - at.y) * STEP + RADIUS,
                    0.0,
                );
                let mut chance = || random.share() - 0.5;
                let away = Vec3A::new(30.0 * chance(), 9.0 + 10.0 * chance(), 24.0 * chance());
                // One after the other from the left.
                let way = smooth((beat - LAST / WIDTH * right) / WAY);
                sphere(scene, away + (home - away) * way, RADIUS, Stuff::Gold);
            }
        }
    }
}
