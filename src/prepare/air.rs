//! The air and the sky.

use crate::scene::Scene;
use glam::Vec3A;

/// What lies between surfaces and rays' starts, and behind everything.
pub(crate) struct Air {
    /// Whether there is neither haze nor a sky whose colour changes with height.
    pub is_clear: bool,
    /// The background at the horizon and below, linear RGB.
    pub horizon: Vec3A,
    /// Added at the zenith.
    pub sky: Vec3A,
}

/// Haze of the background, in 1 / scene units: thick enough to hide it at the distance that stands for "no hit", 1e30, and so
/// thin that it hides nothing at any distance in a scene.
pub(super) const BACKGROUND_HAZE: f32 = 1e-20;

impl Air {
    /// Black and clear, all zeros but for `is_clear`, which is set with a scene.
    pub const ZERO: Self = Self {
        is_clear: false,
        horizon: Vec3A::ZERO,
        sky: Vec3A::ZERO,
    };

    /// The air of a scene.
    pub fn of(scene: &Scene) -> Self {
        Self {
            is_clear: scene.haze == 0.0 && scene.sky == Vec3A::ZERO,
            horizon: scene.background,
            sky: scene.sky,
        }
    }
}
