//! Haze and background.

use super::surface::bounded;
use crate::scene::Scene;
use glam::{Vec3, Vec3A};

/// The haze between surfaces and rays' origins, and the background behind everything. Colours are linear RGB.
pub(crate) struct Air {
    /// Whether there is no haze, and the background has one colour: then nothing here needs to be evaluated.
    pub is_clear: bool,
    /// The background at the horizon and below.
    pub horizon: Vec3A,
    /// Added to it at the zenith, see [`Scene::sky`].
    pub sky: Vec3A,
    /// The density of haze, in 1 / scene units.
    pub haze: f32,
    /// Whether any light has a glow.
    pub glows: bool,
}

impl Air {
    /// All zeros: memory before a frame is prepared.
    pub const ZERO: Self = Self {
        is_clear: false,
        horizon: Vec3A::ZERO,
        sky: Vec3A::ZERO,
        haze: 0.0,
        glows: false,
    };

    /// The air of a scene.
    pub fn of(scene: &Scene) -> Self {
        Self {
            is_clear: scene.haze == 0.0 && scene.sky == Vec3::ZERO,
            horizon: scene.background.into(),
            sky: scene.sky.into(),
            haze: bounded(scene.haze),
            glows: scene.lights.iter().any(|light| light.glow > 0.0),
        }
    }
}
