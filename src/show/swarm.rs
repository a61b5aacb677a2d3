//! The field: 256 spheres that wave, curl to a ball and run along a figure of eight.

use super::material::{self, Stuff};
use super::path::smooth;
use super::things::{around, sphere};
use crate::scene::Scene;
use crate::trigonometry::root;
use crate::trigonometry::{cos, sin};
use core::f32::consts::TAU;
use glam::{Vec3A, vec3a};

/// Spheres along a side of the square they start from.
const SIDE: i32 = 16;
const COUNT: i32 = SIDE * SIDE;

/// The middle of the ball and of the eight.
const MIDDLE: Vec3A = vec3a(0.0, 2.75, 0.0);

/// Colours of the first sphere, and what is different about the last one's: from red to blue.
const RED: Vec3A = vec3a(0.90, 0.15, 0.10);
const TO_BLUE: Vec3A = vec3a(-0.78, 0.17, 0.80);

/// Adds the spheres as they are so many beats after the scene's begin.
pub(super) fn add(beat: f32, scene: &mut Scene) {
    let to_ball = smooth(beat * 0.25 - 1.5);
    let to_eight = smooth(beat * 0.25 - 3.5);
    for i in 0..COUNT {
        one(i, beat, to_ball, to_eight, scene);
    }
}

/// Adds one of them, on its way to the ball and on to the eight.
#[inline(never)]
fn one(i: i32, beat: f32, to_ball: f32, to_eight: f32, scene: &mut Scene) {
    let middle = (SIDE - 1) as f32 * 0.5;
    let (column, row) = ((i % SIDE) as f32 - middle, (i / SIDE) as f32 - middle);
    let flat = vec3a(column, 0.0, row) * 0.75;
    let wave = sin(0.1 * flat.length_squared() - TAU * 0.25 * beat);
    let flat = flat + Vec3A::Y * (0.9 + 0.55 * wave);
    // A ball of turns about its axis, by the golden angle.
    let n = (i as f32 + 0.5) / COUNT as f32;
    let y = 1.0 - 2.0 * n;
    let out = around(0.382 * i as f32 + 0.05 * beat) * root(1.0 - y * y);
    let ball = (out + Vec3A::Y * y) * 2.4 + MIDDLE;
    // A cord along an upright eight.
    let along = TAU * n + 0.2 * beat;
    let eight = vec3a(1.7 * sin(2.0 * along), 2.2 * cos(along), 0.0) + MIDDLE;
    let eight = eight + around(2.0 * along + 0.16 * beat) * 0.5;
    let centre = flat.lerp(ball, to_ball).lerp(eight, to_eight);
    let radius = 0.24 - 0.05 * to_ball;
    let sphere = sphere(scene, centre, radius, Stuff::Scarlet);
    sphere.material.colour = RED + TO_BLUE * smooth(n);
    if wave > 0.8 {
        material::set(&mut sphere.material, Stuff::Gold);
    }
}
