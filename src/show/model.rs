//! The model scene, the default of all measurements: the environment of the show's scene of that name, with an orbiting camera.

use super::path::orbit;
use super::scenes;
use crate::grid::BEAT;
use eightfold_tracer::scene::{Method, Scene};
use glam::vec3;

/// Seconds of one orbit: a full turn at 0.25 radians per second.
pub const MODEL_LENGTH: f32 = 8.0 * core::f32::consts::PI;

pub(super) const ORBIT_SPEED: f32 = 0.25;

/// Sets the model scene at `time` seconds. The camera's path repeats every [`MODEL_LENGTH`].
pub fn model(time: f32, scene: &mut Scene) {
    scenes::model::ENVIRONMENT.apply(time / BEAT, scene);
    scene.camera = orbit(vec3(0.0, 0.9, 0.0), ORBIT_SPEED * time, 7.5, 1.3);
    scene.exposure = 1.0;
    scene.black_beyond = true;
    scene.method = Method::default();
    scene.captions.clear();
}

/// Returns the scene of [`model`].
#[must_use]
pub fn model_scene(time: f32) -> Scene {
    let mut scene = Scene::default();
    model(time, &mut scene);
    scene
}
