//! What things are made of.

use super::steps::{PERCENT, TENTHS, TWENTIETHS, number, rgb, steps, vector};
use crate::scene::{Material, Pattern};
use glam::{Vec3A, vec3a};

/// A material in bytes.
struct Row {
    colour: [i8; 3],
    /// Diffuse, specular, reflected, transmitted: percent.
    shares: [i8; 4],
    exponent: i8,
    /// A row of [`PATTERNS`]; beyond them there is none.
    pattern: u8,
}

/// A pattern in bytes: waves in 20ths, the rest in 10ths.
struct Waves {
    waves: [i8; 3],
    depth: i8,
    edge: i8,
    warp: i8,
    grain: i8,
}

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
    // Metals.
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

const fn row(colour: [i8; 3], shares: [f32; 4], exponent: i8, pattern: u8) -> Row {
    let [kd, ks, kr, kt] = shares;
    Row {
        colour,
        shares: [
            steps(kd, PERCENT),
            steps(ks, PERCENT),
            steps(kr, PERCENT),
            steps(kt, PERCENT),
        ],
        exponent,
        pattern,
    }
}

/// No pattern.
const PLAIN: u8 = 255;
/// Shares of polished metal and of plastic.
const METAL: [f32; 4] = [0.35, 0.8, 0.45, 0.0];
const PLASTIC: [f32; 4] = [0.75, 0.5, 0.15, 0.0];

/// A row for each [`Stuff`].
#[rustfmt::skip]
static MATERIALS: [Row; 15] = [
    //  colour                 kd    ks   kr    kt    exponent pattern
    row(rgb(0.55, 0.55, 0.60), [0.8,  0.1, 0.25, 0.0],  10, PLAIN),
    row(rgb(0.90, 0.15, 0.12), [0.7,  0.5, 0.25, 0.0],  40, PLAIN),
    row(rgb(0.90, 0.90, 0.95), [0.2,  0.8, 0.70, 0.0],  80, PLAIN),
    row(rgb(0.15, 0.35, 0.90), [0.7,  0.5, 0.20, 0.0],  40, PLAIN),
    row(rgb(0.95, 0.95, 0.95), [0.05, 0.8, 0.10, 0.85], 100, PLAIN),
    row(rgb(0.98, 0.73, 0.38), METAL, 60, PLAIN),
    row(rgb(0.85, 0.88, 0.95), METAL, 60, PLAIN),
    row(rgb(0.55, 0.62, 0.75), METAL, 60, PLAIN),
    row(rgb(0.80, 0.11, 0.08), PLASTIC, 40, PLAIN),
    row(rgb(0.90, 0.62, 0.10), PLASTIC, 40, 0),
    row(rgb(0.92, 0.86, 0.78), [0.8,  0.15, 0.0, 0.0],  20, 1),
    row(rgb(0.62, 0.52, 0.44), [0.8,  0.2, 0.22, 0.0],  30, 2),
    row(rgb(0.62, 0.62, 0.66), [0.8,  0.2, 0.25, 0.0],  30, 3),
    row(rgb(0.20, 0.20, 0.27), [0.8,  0.2, 0.45, 0.0],  20, PLAIN),
    row(rgb(0.22, 0.24, 0.34), [0.8,  0.1, 0.35, 0.0],  20, PLAIN),
];

const fn waves(x: f32, y: f32, z: f32, rest: [f32; 4]) -> Waves {
    let [depth, edge, warp, grain] = rest;
    Waves {
        waves: [
            steps(x, TWENTIETHS),
            steps(y, TWENTIETHS),
            steps(z, TWENTIETHS),
        ],
        depth: steps(depth, TENTHS),
        edge: steps(edge, TENTHS),
        warp: steps(warp, TENTHS),
        grain: steps(grain, TENTHS),
    }
}

/// Stripes, veins, tiles.
#[rustfmt::skip]
static PATTERNS: [Waves; 4] = [
    //    x     y    z      depth edge warp grain
    waves(0.0,  1.0, 0.0,  [0.7, 12.0, 0.0, 0.0]),
    waves(0.5,  0.9, 0.3,  [0.6,  1.0, 1.2, 0.9]),
    waves(0.4,  0.0, 0.4,  [0.6, 12.0, 0.0, 0.0]),
    waves(0.55, 0.0, 0.55, [0.6, 12.0, 0.0, 0.0]),
];

/// The tint of shadows, as if all light were transmitted.
const TINT: Vec3A = vec3a(0.65, 0.88, 1.1);

/// Gives a thing its material.
pub(super) fn set(material: &mut Material, stuff: Stuff) {
    let row = &MATERIALS[stuff as usize];
    let [kd, ks, kr, kt] = row.shares.map(|share| number(share, PERCENT));
    *material = Material {
        colour: vector(row.colour, PERCENT),
        kd,
        ks,
        exponent: f32::from(row.exponent),
        kr,
        kt,
        index: 1.5,
        tint: TINT * kt,
        pattern: PATTERNS
            .get(row.pattern as usize)
            .map_or(Pattern::NONE, |row| Pattern {
                waves: vector(row.waves, TWENTIETHS),
                depth: number(row.depth, TENTHS),
                edge: number(row.edge, TENTHS),
                warp: number(row.warp, TENTHS),
                grain: number(row.grain, TENTHS),
            }),
    };
}
