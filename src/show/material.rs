//! What things are made of.

use crate::scene::{Material, Pattern};
use glam::{Vec3A, vec3a};

/// A material of the show.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum MaterialId {
    /// The model scene's floor.
    Paper,
    /// The model scene's spheres.
    Red,
    Mirror,
    Blue,
    Glass,
    /// Glass that mirrors nothing: what little there would be takes a fifth of the time of a frame that the ball fills.
    Crystal,
    /// Metals.
    Gold,
    Silver,
    /// Cast, and mirrors nothing: that took a quarter of the machine's time, and was hardly seen.
    Steel,
    /// Plastics.
    Scarlet,
    Striped,
    /// Stone.
    Marble,
    Sandstone,
    Slate,
    /// Floors as smooth as water.
    Dusk,
    Night,
}

/// How shadows of glass are tinted, as if all light were transmitted.
const TINT: Vec3A = vec3a(0.65, 0.88, 1.1);

/// Neither mirrors nor is transparent.
const MATT: Material = Material {
    index: 1.5,
    ..Material::BLACK
};

impl MaterialId {
    /// The material itself.
    pub fn material(self) -> Material {
        let material = match self {
            Self::Paper => Material {
                colour: vec3a(0.55, 0.55, 0.6),
                kd: 0.8,
                ks: 0.1,
                exponent: 10.0,
                kr: 0.25,
                ..MATT
            },
            Self::Red => Material {
                colour: vec3a(0.9, 0.15, 0.12),
                kd: 0.7,
                ks: 0.5,
                exponent: 40.0,
                kr: 0.25,
                ..MATT
            },
            Self::Mirror => Material {
                colour: vec3a(0.9, 0.9, 0.95),
                kd: 0.2,
                ks: 0.8,
                exponent: 80.0,
                kr: 0.7,
                ..MATT
            },
            Self::Blue => Material {
                colour: vec3a(0.15, 0.35, 0.9),
                kd: 0.7,
                ks: 0.5,
                exponent: 40.0,
                kr: 0.2,
                ..MATT
            },
            Self::Glass => Material {
                colour: vec3a(0.95, 0.95, 0.95),
                kd: 0.05,
                ks: 0.8,
                exponent: 100.0,
                kr: 0.1,
                kt: 0.85,
                ..MATT
            },
            Self::Crystal => Material {
                colour: vec3a(0.95, 0.95, 0.95),
                kd: 0.05,
                ks: 0.8,
                exponent: 100.0,
                kt: 0.9,
                ..MATT
            },
            Self::Gold => Material {
                colour: vec3a(0.98, 0.73, 0.38),
                kd: 0.6,
                ks: 0.5,
                exponent: 25.0,
                kr: 0.2,
                ..MATT
            },
            Self::Silver => Material {
                colour: vec3a(0.85, 0.88, 0.95),
                kd: 0.4,
                ks: 0.8,
                exponent: 60.0,
                kr: 0.32,
                ..MATT
            },
            Self::Steel => Material {
                colour: vec3a(0.55, 0.62, 0.75),
                kd: 0.55,
                ks: 0.5,
                exponent: 25.0,
                ..MATT
            },
            Self::Scarlet => Material {
                colour: vec3a(0.8, 0.11, 0.08),
                kd: 0.8,
                ks: 0.25,
                exponent: 25.0,
                ..MATT
            },
            Self::Striped => Material {
                colour: vec3a(0.9, 0.62, 0.1),
                kd: 0.8,
                ks: 0.4,
                exponent: 40.0,
                pattern: Pattern {
                    waves: vec3a(0.0, 1.0, 0.0),
                    depth: 0.7,
                    edge: 30.0,
                    ..Pattern::NONE
                },
                ..MATT
            },
            Self::Marble => Material {
                colour: vec3a(0.92, 0.86, 0.78),
                kd: 0.8,
                ks: 0.15,
                exponent: 20.0,
                pattern: Pattern {
                    waves: vec3a(0.5, 0.9, 0.3),
                    depth: 0.6,
                    edge: 1.0,
                    warp: 1.1,
                    grain: 0.9,
                    ..Pattern::NONE
                },
                ..MATT
            },
            Self::Sandstone => Material {
                colour: vec3a(0.62, 0.52, 0.44),
                kd: 0.8,
                ks: 0.2,
                exponent: 30.0,
                kr: 0.15,
                pattern: Pattern {
                    waves: vec3a(0.38, 0.0, 0.38),
                    depth: 0.6,
                    edge: 40.0,
                    ..Pattern::NONE
                },
                ..MATT
            },
            Self::Slate => Material {
                colour: vec3a(0.62, 0.62, 0.66),
                kd: 0.8,
                ks: 0.2,
                exponent: 30.0,
                kr: 0.2,
                pattern: Pattern {
                    waves: vec3a(0.55, 0.0, 0.55),
                    depth: 0.38,
                    edge: 40.0,
                    ..Pattern::NONE
                },
                ..MATT
            },
            Self::Dusk => Material {
                colour: vec3a(0.2, 0.2, 0.27),
                kd: 0.8,
                ks: 0.2,
                exponent: 20.0,
                kr: 0.45,
                ..MATT
            },
            Self::Night => Material {
                colour: vec3a(0.22, 0.24, 0.34),
                kd: 0.8,
                ks: 0.1,
                exponent: 20.0,
                kr: 0.24,
                ..MATT
            },
        };
        Material {
            tint: TINT * material.kt,
            ..material
        }
    }
}
