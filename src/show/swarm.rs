//! The swarm: 256 spheres that wave, set off one after another to build a ball, and go on to a figure of eight.

use super::material;
use super::props::around;
use crate::maths::{cos, sin, smooth_step, sqrt};
use crate::scene::{Material, Scene, Sphere};
use core::f32::consts::TAU;
use glam::{Vec3A, vec3a};

/// Spheres along a side of the square they start from.
const SIDE: i32 = 16;
const COUNT: i32 = SIDE * SIDE;
/// Spheres side by side on the eight, which is a band.
const WIDE: i32 = 4;

/// The middle of the ball and of the eight.
const MIDDLE: Vec3A = vec3a(0.0, 2.75, 0.0);

/// Colours of the first sphere, and what is different about the last one's: from red to blue.
const RED: Vec3A = vec3a(0.90, 0.15, 0.10);
const TO_BLUE: Vec3A = vec3a(-0.78, 0.17, 0.80);
/// Colour of the waves' crests: darker than [`material::GOLD`], since plastic scatters more of the light.
const GOLD: Vec3A = vec3a(0.85, 0.62, 0.30);

/// Adds the spheres as they are so many beats after the scene's begin.
pub(super) fn add(beat: f32, scene: &mut Scene) {
    for i in 0..COUNT {
        scene.spheres.push(sphere(i, beat));
    }
}

/// One of them, on its way to the ball and on to the eight.
fn sphere(i: i32, beat: f32) -> Sphere {
    let middle = (SIDE - 1) as f32 * 0.5;
    let (column, row) = ((i % SIDE) as f32 - middle, (i / SIDE) as f32 - middle);
    let flat = vec3a(column, 0.0, row) * 0.75;
    let wave = sin(0.1 * flat.length_squared() - TAU * 0.25 * beat);
    let flat = flat + Vec3A::Y * (0.9 + 0.55 * wave);
    // A ball of turns about its axis, by the golden angle.
    let n = (i as f32 + 0.5) / COUNT as f32;
    let y = 1.0 - 2.0 * n;
    let out = around(0.382 * i as f32 + 0.05 * beat) * sqrt(1.0 - y * y);
    let ball = (out + Vec3A::Y * y) * 2.4 + MIDDLE;
    // The band is 1.2 nearer on one of its ways through the crossing, and as much farther on the other: it passes itself.
    let along = (i / WIDE) as f32 * (TAU * WIDE as f32 / COUNT as f32) + 0.2 * beat;
    let across = (i % WIDE) as f32 * 0.36 - 0.54 + 1.2 * sin(along);
    let eight = vec3a(1.4 * sin(2.0 * along), 2.3 * cos(along), across) + MIDDLE;
    // A way takes 1 / 0.3 beats, and the last sphere sets off 1.3 of these after the first.
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
            kr: 0.2 * gold,
            ..material::SCARLET
        },
    }
}
