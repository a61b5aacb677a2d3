//! What things are made of.

use super::steps::{PERCENT, numbers, steps};
use crate::scene::{Material, Pattern};
use glam::{Vec3A, vec3a};

/// What a thing of a scene is made of.
#[derive(Clone, Copy, PartialEq)]
#[repr(u8)]
pub(super) enum Stuff {
    // The model scene's.
    Paper,
    Red,
    Mirror,
    Blue,
    Glass,
    // Glass that mirrors nothing: what little there would be takes a fifth of the time of a frame that the ball fills.
    Crystal,
    // Metals; steel is cast, and mirrors nothing: that took a quarter of the machine's time, and was hardly seen.
    Gold,
    Silver,
    Steel,
    // Plastics.
    Scarlet,
    Striped,
    // Stone.
    Marble,
    Sandstone,
    Slate,
    // Floors as smooth as water.
    Dusk,
    Night,
}

/// A row for each [`Stuff`], in percent; exponents and edges are a hundred times as large as they are here.
#[rustfmt::skip]
static MATERIALS: [[i8; 15]; 16] = [
    //    red   green blue  kd    ks    kr    kt    exponent  waves along x, y, z  depth edge warp grain
    steps([0.55, 0.55, 0.60, 0.8,  0.1,  0.25, 0.0,  0.1,  0.0,  0.0, 0.0,  0.0, 0.0,  0.0, 0.0], PERCENT),
    steps([0.90, 0.15, 0.12, 0.7,  0.5,  0.25, 0.0,  0.4,  0.0,  0.0, 0.0,  0.0, 0.0,  0.0, 0.0], PERCENT),
    steps([0.90, 0.90, 0.95, 0.2,  0.8,  0.70, 0.0,  0.8,  0.0,  0.0, 0.0,  0.0, 0.0,  0.0, 0.0], PERCENT),
    steps([0.15, 0.35, 0.90, 0.7,  0.5,  0.20, 0.0,  0.4,  0.0,  0.0, 0.0,  0.0, 0.0,  0.0, 0.0], PERCENT),
    steps([0.95, 0.95, 0.95, 0.05, 0.8,  0.10, 0.85, 1.0,  0.0,  0.0, 0.0,  0.0, 0.0,  0.0, 0.0], PERCENT),
    steps([0.95, 0.95, 0.95, 0.05, 0.8,  0.0,  0.90, 1.0,  0.0,  0.0, 0.0,  0.0, 0.0,  0.0, 0.0], PERCENT),
    steps([0.98, 0.73, 0.38, 0.60, 0.5,  0.20, 0.0,  0.25, 0.0,  0.0, 0.0,  0.0, 0.0,  0.0, 0.0], PERCENT),
    steps([0.85, 0.88, 0.95, 0.40, 0.8,  0.32, 0.0,  0.6,  0.0,  0.0, 0.0,  0.0, 0.0,  0.0, 0.0], PERCENT),
    steps([0.55, 0.62, 0.75, 0.55, 0.5,  0.0,  0.0,  0.25, 0.0,  0.0, 0.0,  0.0, 0.0,  0.0, 0.0], PERCENT),
    steps([0.80, 0.11, 0.08, 0.80, 0.25, 0.0,  0.0,  0.25, 0.0,  0.0, 0.0,  0.0, 0.0,  0.0, 0.0], PERCENT),
    steps([0.90, 0.62, 0.10, 0.80, 0.4,  0.0,  0.0,  0.4,  0.0,  1.0, 0.0,  0.7, 0.3,  0.0, 0.0], PERCENT),
    steps([0.92, 0.86, 0.78, 0.8,  0.15, 0.0,  0.0,  0.2,  0.5,  0.9, 0.3,  0.6, 0.01, 1.1, 0.9], PERCENT),
    steps([0.62, 0.52, 0.44, 0.8,  0.2,  0.15, 0.0,  0.3,  0.38, 0.0, 0.38, 0.6, 0.4,  0.0, 0.0], PERCENT),
    steps([0.62, 0.62, 0.66, 0.8,  0.2,  0.20, 0.0,  0.3,  0.55, 0.0, 0.55, 0.38, 0.4,  0.0, 0.0], PERCENT),
    steps([0.20, 0.20, 0.27, 0.8,  0.2,  0.45, 0.0,  0.2,  0.0,  0.0, 0.0,  0.0, 0.0,  0.0, 0.0], PERCENT),
    steps([0.22, 0.24, 0.34, 0.8,  0.1,  0.24, 0.0,  0.2,  0.0,  0.0, 0.0,  0.0, 0.0,  0.0, 0.0], PERCENT),
];

/// The tint of shadows, as if all light were transmitted.
const TINT: Vec3A = vec3a(0.65, 0.88, 1.1);

/// Gives a thing its material.
#[inline(never)]
pub(super) fn set(material: &mut Material, stuff: Stuff) {
    let row = numbers(&MATERIALS[stuff as usize], PERCENT);
    let [red, green, blue, kd, ks, kr, kt, exponent, rest @ ..] = row;
    let [x, y, z, depth, edge, warp, grain, _] = rest;
    material.colour = vec3a(red, green, blue);
    material.kd = kd;
    material.ks = ks;
    material.exponent = exponent * 100.0;
    material.kr = kr;
    material.kt = kt;
    material.index = 1.5;
    material.tint = TINT * kt;
    material.pattern = Pattern {
        waves: vec3a(x, y, z),
        depth,
        edge: edge * 100.0,
        warp,
        grain,
    };
}
