//! The scene that is shown: by its name or from its file, through its own camera or one that was moved by the mouse.

use super::camera;
use super::watched::Watched;
use crate::scenes::SceneName;
use eightfold_tracer::glam::{Vec2, vec2};
use eightfold_tracer::scene::{Camera, Scene};
use eightfold_window::input::{Action, Button, Mouse};
use std::f32::consts::PI;

/// A scene and its camera.
pub struct Subject {
    name: SceneName,
    /// The scene file, if it is one.
    file: Option<Watched>,
    /// The camera, once it was moved by the mouse.
    camera: Option<Camera>,
    /// The button that is held, and the last place of the pointer in the window.
    held: Option<(Button, Vec2)>,
    /// Is another one after each change of the scene and of the camera.
    pub version: u64,
}

impl Subject {
    pub fn new(name: SceneName) -> Self {
        let file = match name {
            SceneName::File(file) => Some(Watched::new(file.clone())),
            _ => None,
        };
        Self {
            name,
            file,
            camera: None,
            held: None,
            version: 0,
        }
    }

    /// Returns the scene at a time in seconds, as it is seen.
    pub fn at(&self, time: f32) -> Scene {
        let mut scene = match &self.file {
            Some(file) => file.scene.at(time),
            None => self.name.at(time),
        };
        if let Some(camera) = self.camera {
            scene.camera = camera;
        }
        scene
    }

    /// Returns the scene's length in seconds.
    pub fn length(&self) -> f32 {
        let file = self.file.as_ref();
        file.map_or(self.name.length(), |file| file.scene.length)
    }

    /// Returns the mistake in the scene's file.
    pub fn fault(&self) -> Option<&str> {
        self.file.as_ref()?.fault.as_deref()
    }

    /// Reads the scene's file again if it has changed.
    pub fn look(&mut self) {
        if self.file.as_mut().is_some_and(Watched::look) {
            self.version += 1;
        }
    }

    /// Takes back what the mouse did.
    pub fn reset_camera(&mut self) {
        self.camera = None;
        self.version += 1;
    }

    /// Moves the camera by the mouse, at a time in seconds, in a window of a height in pixels.
    pub fn point(&mut self, mouse: Mouse, time: f32, height: usize) {
        let at = vec2(mouse.x as f32, mouse.y as f32);
        match mouse.action {
            Action::Down(button) => self.held = Some((button, at)),
            Action::Wheel(notches) => {
                self.move_camera(time, |camera| camera::zoom(camera, notches))
            }
            Action::Move | Action::Up(_) => {
                if let Some((button, last)) = &mut self.held {
                    let by = (at - *last) / height as f32;
                    *last = at;
                    match button {
                        // A drag over the whole height is half a turn.
                        Button::Left => {
                            self.move_camera(time, |camera| {
                                camera::orbit(camera, by.x * PI, by.y * PI)
                            });
                        }
                        _ => self.move_camera(time, |camera| camera::pan(camera, by)),
                    }
                }
                if mouse.action != Action::Move {
                    self.held = None;
                }
            }
        }
    }

    /// Changes the camera, unless the tracer takes none such.
    fn move_camera(&mut self, time: f32, change: impl FnOnce(&mut Camera)) {
        let mut scene = self.at(time);
        change(&mut scene.camera);
        if scene.validate().is_ok() {
            self.camera = Some(scene.camera);
            self.version += 1;
        }
    }
}
