//! The ways in which frames are drawn, which are measured against each other.

use crate::scenes::SceneName;
use eightfold_tracer::Quality;
use eightfold_tracer::scene::Scene;

/// How a frame is drawn.
#[derive(Clone, PartialEq)]
pub struct Way {
    /// Its name in tables.
    pub name: String,
    pub quality: Quality,
    /// Whether lamps throw shadows as points do, whatever their size.
    pub hard_shadows: bool,
}

impl Way {
    /// A quality with shadows as they are.
    pub fn new(name: &str, quality: Quality) -> Self {
        Self {
            name: name.to_owned(),
            quality,
            hard_shadows: false,
        }
    }

    /// The scene of a time.
    pub fn scene(&self, scene: SceneName, time: f32) -> Scene {
        let mut scene = scene.without_overlay(time);
        if self.hard_shadows {
            for light in scene.lights.iter_mut() {
                light.diameter = 0.0;
            }
        }
        scene
    }

    /// The scene of a time, if it takes no part in the time of a frame: what a scene file says is put together before, as no
    /// program does that in each frame.
    pub fn made_before(&self, scene: SceneName, time: f32) -> Option<Scene> {
        matches!(scene, SceneName::File(_)).then(|| self.scene(scene, time))
    }
}
