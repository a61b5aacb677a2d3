use crate::scenes::{self, SceneName};
use eightfold_scene_file::SceneFile;
use eightfold_tracer::glam::{Quat, Vec2, vec2};
use eightfold_tracer::presentation::Moment;
use eightfold_tracer::scene::Camera;
use eightfold_window::input::{Action, Button, Mouse};
use std::f32::consts::PI;
use std::path::Path;

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

    pub fn reload(&mut self) {
        if self.file.as_mut().is_some_and(Watched::reload) {
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
            Action::Wheel(notches) => self.move_camera(time, |camera| zoom(camera, notches)),
            Action::Move | Action::Up(_) => {
                if let Some((button, last)) = &mut self.pressed {
                    let by = at - *last;
                    *last = at;
                    // The full height is half a turn.
                    let turn = by * (PI / size.1 as f32);
                    match button {
                        Button::Left => {
                            self.move_camera(time, |it| orbit(it, turn.x, turn.y));
                        }
                        _ => self.move_camera(time, |it| pan(it, by, size)),
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

struct Watched {
    scene: SceneFile,
    /// The last text, or a read error; `None` before the first look.
    text: Option<Result<String, String>>,
    /// A mistake read once: the file may be half written.
    suspect: Option<String>,
    mistake: Option<String>,
}

impl Watched {
    fn new(scene: SceneFile) -> Self {
        Self { scene, text: None, suspect: None, mistake: None }
    }

    /// Returns whether the scene has changed. Modification times are too coarse for quick writes.
    fn reload(&mut self) -> bool {
        let name = &self.scene.name;
        let text = scenes::text(Path::new(name));
        if self.text.as_ref() == Some(&text) {
            if self.suspect.is_some() {
                self.mistake = self.suspect.take();
            }
            return false;
        }
        let read = text.as_ref().map_err(String::clone);
        let read = read.and_then(|text| SceneFile::parse(name, text));
        self.text = Some(text);
        match read {
            Ok(scene) => {
                self.scene = scene;
                (self.suspect, self.mistake) = (None, None);
                true
            }
            Err(mistake) => {
                self.suspect = Some(mistake);
                false
            }
        }
    }
}

/// The largest cosine between the view and `up`; at 1 there is no right vector.
const STEEPEST: f32 = 0.998;

const NOTCH: f32 = 1.1;

fn orbit(camera: &mut Camera, left: f32, upwards: f32) {
    let up = camera.up.normalize();
    let around = Quat::from_axis_angle(up, -left) * (camera.eye - camera.look_at);
    let right = up.cross(around).normalize();
    let over = Quat::from_axis_angle(right, -upwards) * around;
    let [before, after] = [around, over].map(|away| away.normalize().dot(up).abs());
    let is_too_steep = after > STEEPEST.max(before);
    camera.eye = camera.look_at + if is_too_steep { around } else { over };
}

/// Moves the camera sideways by pixels, so the target follows the pointer.
fn pan(camera: &mut Camera, by: Vec2, (width, height): (usize, usize)) {
    let picture = camera.raster(width, height);
    let distance = (camera.look_at - camera.eye).length();
    let offset = (picture.dx * by.x + picture.dy * by.y) * -distance;
    camera.eye += offset;
    camera.look_at += offset;
}

fn zoom(camera: &mut Camera, notches: i32) {
    let away = camera.eye - camera.look_at;
    camera.eye = camera.look_at + away * NOTCH.powi(-notches);
}

/// Formats the scene file's field, exact to the bit.
pub fn ron(camera: &Camera) -> String {
    format!("camera: {},\n", ron::to_string(camera).expect("numbers"))
}
