//! Haze and background.

use crate::scene::Scene;
use glam::Vec3A;

/// The haze between surfaces and rays' origins, and the background behind everything. Colours are linear RGB.
pub(crate) struct Air {
    /// Whether there is no haze, and the background has one colour: then nothing here needs to be evaluated.
    pub is_clear: bool,
    /// The background at the horizon and below.
    pub horizon: Vec3A,
    /// Added to it at the zenith, see [`Scene::sky`].
    pub sky: Vec3A,
    /// Whether any light has a glow.
    pub glows: bool,
}

/// The density of haze added for the background, in 1 / scene units. It is dense enough to hide everything at the distance that
/// stands for "no hit", 1e30, so that the sky replaces it, and too thin to be visible at any distance within a scene.
pub(super) const BACKGROUND_HAZE: f32 = 1e-20;

impl Air {
    /// All zeros: memory before a frame is prepared.
    pub const ZERO: Self = Self {
        is_clear: false,
        horizon: Vec3A::ZERO,
        sky: Vec3A::ZERO,
        glows: false,
    };

    /// The air of a scene.
    pub fn of(scene: &Scene) -> Self {
        Self {
            is_clear: scene.haze == 0.0 && scene.sky == Vec3A::ZERO,
            horizon: scene.background,
            sky: scene.sky,
            glows: scene.lights.iter().any(|light| light.glow > 0.0),
        }
    }
}
