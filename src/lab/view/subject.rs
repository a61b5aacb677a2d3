use super::camera;
use super::watched::Watched;
use crate::scenes::SceneName;
use eightfold_tracer::glam::{Vec2, vec2};
use eightfold_tracer::scene::{Camera, Moment};
use eightfold_window::input::{Action, Button, Mouse};
use std::f32::consts::PI;

pub struct Subject {
    name: SceneName,
    file: Option<Watched>,
    /// Set by the mouse.
    camera: Option<Camera>,
    /// With the last position of the pointer.
    pressed: Option<(Button, Vec2)>,
    pub version: u64,
}

impl Subject {
    pub fn new(name: SceneName) -> Self {
        let file = match name {
            SceneName::File(file) => Some(Watched::new(file.clone())),
            _ => None,
        };
        Self { name, file, camera: None, pressed: None, version: 0 }
    }

    pub fn at(&self, time: f32) -> Moment {
        let mut moment = match &self.file {
            Some(file) => file.scene.at(time),
            None => self.name.at(time),
        };
        if let Some(camera) = self.camera {
            moment.scene.camera = camera;
        }
        moment
    }

    /// Seconds.
    pub fn length(&self) -> f32 {
        let file = self.file.as_ref();
        file.map_or(self.name.length(), |file| file.scene.length)
    }

    pub fn mistake(&self) -> Option<&str> {
        self.file.as_ref()?.mistake.as_deref()
    }

    pub fn look(&mut self) {
        if self.file.as_mut().is_some_and(Watched::look) {
            self.version += 1;
        }
    }

    pub fn reset_camera(&mut self) {
        self.camera = None;
        self.version += 1;
    }

    /// `time` is in seconds, the window's `size` in pixels.
    pub fn point(&mut self, mouse: Mouse, time: f32, size: (usize, usize)) {
        let at = vec2(mouse.x as f32, mouse.y as f32);
        match mouse.action {
            Action::Down(button) => self.pressed = Some((button, at)),
            Action::Wheel(notches) => {
                self.move_camera(time, |camera| camera::zoom(camera, notches))
            }
            Action::Move | Action::Up(_) => {
                if let Some((button, last)) = &mut self.pressed {
                    let by = at - *last;
                    *last = at;
                    // The full height is half a turn.
                    let turn = by * (PI / size.1 as f32);
                    match button {
                        Button::Left => {
                            self.move_camera(time, |it| camera::orbit(it, turn.x, turn.y));
                        }
                        _ => self.move_camera(time, |it| camera::pan(it, by, size)),
                    }
                }
                if mouse.action != Action::Move {
                    self.pressed = None;
                }
            }
        }
    }

    /// Ignores invalid results.
    fn move_camera(&mut self, time: f32, change: impl FnOnce(&mut Camera)) {
        let Moment { mut scene, .. } = self.at(time);
        change(&mut scene.camera);
        if scene.validate().is_ok() {
            self.camera = Some(scene.camera);
            self.version += 1;
        }
    }
}
