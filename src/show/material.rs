//! What things are made of.

use crate::scene::{Material, Pattern};
use glam::{Vec3A, vec3a};

/// Shiny plastic.
pub(super) const fn plastic(colour: Vec3A) -> Material {
    Material {
        colour,
        kd: 0.75,
        ks: 0.5,
        exponent: 40.0,
        kr: 0.15,
        ..Material::BLACK
    }
}

/// Polished metal.
pub(super) const fn metal(colour: Vec3A) -> Material {
    Material {
        colour,
        kd: 0.35,
        ks: 0.8,
        exponent: 60.0,
        kr: 0.45,
        ..Material::BLACK
    }
}

/// Clear glass, whose shadows are tinted.
pub(super) const GLASS: Material = Material {
    colour: Vec3A::splat(0.95),
    kd: 0.05,
    ks: 0.8,
    exponent: 100.0,
    kr: 0.12,
    kt: 0.85,
    index: 1.5,
    tint: vec3a(0.55, 0.75, 0.95),
    ..Material::BLACK
};

/// Stone with dark veins, matt.
pub(super) const MARBLE: Material = Material {
    colour: vec3a(0.92, 0.86, 0.78),
    kd: 0.8,
    ks: 0.15,
    exponent: 20.0,
    pattern: Pattern {
        waves: vec3a(0.5, 0.9, 0.3),
        depth: 0.55,
        edge: 1.0,
        warp: 1.2,
        grain: 0.9,
    },
    ..Material::BLACK
};

/// Dark stone tiles, polished.
pub(super) const fn tiles(colour: Vec3A, size: f32, kr: f32) -> Material {
    Material {
        colour,
        kd: 0.8,
        ks: 0.2,
        exponent: 30.0,
        kr,
        pattern: Pattern {
            waves: vec3a(0.5 / size, 0.0, 0.5 / size),
            depth: 0.6,
            edge: 40.0,
            ..Pattern::NONE
        },
        ..Material::BLACK
    }
}
