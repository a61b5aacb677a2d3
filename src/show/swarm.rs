//! The field: 256 spheres that wave, curl to a ball and run along a figure of eight.

use super::material::Stuff;
use super::path::smooth;
use super::things::sphere;
use crate::scene::Scene;
use crate::trigonometry::{cos, sin};
use core::f32::consts::TAU;
use glam::{Vec3A, vec3a};

/// Spheres along a side of the square they start from.
const SIDE: u32 = 16;
const COUNT: u32 = SIDE * SIDE;

/// Colours of the first sphere, and what is different about the last one's: from red to blue.
const RED: Vec3A = vec3a(0.90, 0.15, 0.10);
const TO_BLUE: Vec3A = vec3a(-0.78, 0.17, 0.80);

/// Adds the spheres as they are so many beats after the scene's begin.
pub(super) fn add(beat: f32, scene: &mut Scene) {
    let to_ball = smooth(beat * 0.25 - 1.5);
    let to_eight = smooth(beat * 0.25 - 3.5);
    for i in 0..COUNT {
        let middle = (SIDE - 1) as f32 * 0.5;
        let (column, row) = ((i % SIDE) as f32 - middle, (i / SIDE) as f32 - middle);
        let wave = sin(0.06 * (column * column + row * row) - TAU * 0.25 * beat);
        let flat = Vec3A::new(0.75 * column, 0.9 + 0.55 * wave, 0.75 * row);
        // A ball of turns about its axis, by the golden angle.
        let n = (i as f32 + 0.5) / COUNT as f32;
        let turn = 2.4 * i as f32 + 0.3 * beat;
        let y = 1.0 - 2.0 * n;
        let across = libm::sqrtf(1.0 - y * y);
        let swell = 2.3 + 0.15 * sin(TAU * 0.5 * beat);
        let ball = Vec3A::new(across * cos(turn), y, across * sin(turn)) * swell + Vec3A::Y * 2.7;
        // A cord along an upright eight.
        let along = TAU * n + 0.2 * beat;
        let twist = 12.0 * along + beat;
        let eight = Vec3A::new(
            1.7 * sin(2.0 * along) + 0.45 * cos(twist),
            2.8 + 2.2 * cos(along) + 0.45 * sin(twist),
            0.5 * sin(along),
        );
        let centre = flat + (ball - flat) * to_ball;
        let centre = centre + (eight - centre) * to_eight;
        let radius = 0.24 - 0.05 * to_ball;
        if wave > 0.6 {
            sphere(scene, centre, radius, Stuff::Gold);
        } else {
            let sphere = sphere(scene, centre, radius, Stuff::Scarlet);
            sphere.material.colour = RED + TO_BLUE * smooth(n);
        }
    }
}
