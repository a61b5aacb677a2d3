//! Changes of a scene file by gestures and keys.

use super::camera::View;
use super::document::{Document, Step};
use super::objects::Picked;
use eightfold_scene_file::edit::{self, Changes};
use eightfold_tracer::glam::{DVec2, DVec3};
use eightfold_tracer::scene::{Camera, Scene};
use serde_json::{Value, json};

/// A scene file that is edited, and the object that is picked.
pub struct Editor {
    pub document: Document,
    pub picked: Option<Picked>,
}

/// An object that is being dragged. The document holds the text that the drag began with.
pub struct Drag {
    object: Picked,
    /// The object's centre when it began.
    centre: DVec3,
    /// A point at the distance of the object's centre, which follows the pointer.
    held: DVec3,
    /// The way of the object so far.
    way: DVec3,
    /// Where the pointer was last.
    last: DVec2,
    /// Whether it goes up and down.
    is_vertical: bool,
    /// The way when that last changed.
    way_before: DVec3,
    /// Numbers are rounded to multiples of this.
    grain: f64,
}

/// The factor of a notch of the wheel on an object's size.
const NOTCH: f64 = 1.05;

/// How many times its width a copy is beside its original.
const BESIDE: f64 = 1.1;

impl Editor {
    pub fn new(document: Document) -> Self {
        Self {
            document,
            picked: None,
        }
    }

    /// Begins to drag the picked object, held at a place of the picture.
    pub fn drag(&mut self, scene: &Scene, view: &View, at: DVec2) -> Option<Drag> {
        let object = self.picked?;
        let (centre, _) = object.bounds(scene)?;
        let held = view.on_plane(at, centre, view.forward)?;
        self.document.hold();
        Some(Drag {
            object,
            centre,
            held,
            way: DVec3::ZERO,
            last: at,
            is_vertical: false,
            way_before: DVec3::ZERO,
            grain: grain(view.pixel * view.depth(centre)),
        })
    }

    /// Moves the dragged object to where the pointer is, unless something else has ended the drag.
    ///
    /// # Errors
    /// A value that the scene file does not take.
    pub fn drag_on(
        &mut self,
        drag: &mut Drag,
        view: &View,
        at: DVec2,
        is_vertical: bool,
    ) -> Result<(), String> {
        if drag.is_vertical != is_vertical {
            drag.is_vertical = is_vertical;
            drag.way_before = drag.way;
            if let Some(held) = view.on_plane(drag.last, drag.held + drag.way, view.forward) {
                drag.held = held - drag.way;
            }
        }
        drag.last = at;
        let from = drag.held + drag.way_before;
        let level = DVec3::new(view.forward.x, 0.0, view.forward.z);
        let normal = if is_vertical && level != DVec3::ZERO {
            level
        } else {
            DVec3::Y
        };
        let Some(to) = view.on_plane(at, from, normal) else {
            return Ok(());
        };
        let mask = if is_vertical {
            DVec3::Y
        } else {
            DVec3::new(1.0, 0.0, 1.0)
        };
        let way = drag.way_before + (to - from) * mask;
        // The place that it comes to is round, not the way.
        let end = drag.centre + way;
        drag.way = way;
        let rounded = (end / drag.grain).round() * drag.grain - drag.centre;
        let way = DVec3::select(way.cmpne(DVec3::ZERO), rounded, DVec3::ZERO);
        let Some(held) = self.document.held() else {
            return Ok(());
        };
        let path = drag.object.centre_path();
        let changes = held.scene.changed(&path, |i, number| number + way[i]);
        let text = edit::set(&held.text, &changes).ok_or(NOT_IN_TEXT)?;
        self.document.change(text, Some(Step::Drag))
    }

    /// Makes the picked object larger, or smaller, by notches of the wheel.
    ///
    /// # Errors
    /// A value that the scene file does not take.
    pub fn resize(&mut self, notches: f64) -> Result<(), String> {
        let Some(object) = self.picked else {
            return Ok(());
        };
        let factor = NOTCH.powf(notches);
        let paths = object.size_paths().into_iter();
        let changes: Changes = paths
            .flat_map(|path| {
                let scaled = |_, number: f64| three_digits(number * factor);
                self.document.scene.changed(&path, scaled)
            })
            .collect();
        self.set(&changes, Some(Step::Resize(object.index)))
    }

    /// Gives the picked object the next material of the table.
    ///
    /// # Errors
    /// A value that the scene file does not take, or that lights have no material.
    pub fn next_material(&mut self) -> Result<(), String> {
        let object = self.picked.ok_or(NOTHING)?;
        let scene = &self.document.scene;
        let material = object.material(scene).ok_or("a light has no material")?;
        let names = scene.materials();
        let at = names.iter().position(|name| *name == material);
        let next = names[(at.unwrap_or(0) + 1) % names.len()];
        let changes = [(format!("{}.material", object.path()), json!(next))];
        self.set(&changes, None)
    }

    /// Deletes the picked object.
    ///
    /// # Errors
    /// A change that the scene file does not take.
    pub fn delete(&mut self) -> Result<(), String> {
        let object = self.picked.ok_or(NOTHING)?;
        let text = edit::remove(self.document.text(), object.list(), object.index);
        self.document.change(text.ok_or(NOT_IN_TEXT)?, None)?;
        self.picked = None;
        Ok(())
    }

    /// Puts a copy of the picked object to its right, and picks that.
    ///
    /// # Errors
    /// A change that the scene file does not take.
    pub fn duplicate(&mut self, scene: &Scene, view: &View) -> Result<(), String> {
        let object = self.picked.ok_or(NOTHING)?;
        let (centre, half) = object.bounds(scene).ok_or(NOTHING)?;
        let text = self.document.text();
        let text = edit::duplicate(text, object.list(), object.index).ok_or(NOT_IN_TEXT)?;
        let file = self.document.parse(&text)?;
        let list = file.value(object.list()).and_then(|list| list.as_array());
        let copy = Picked {
            index: list.map_or(0, |list| list.len() - 1),
            ..object
        };
        // Along the axis of the scene that is nearest to the right, so that a row of copies is straight.
        let axis = match view.right.x.abs() >= view.right.z.abs() {
            true => DVec3::X * view.right.x.signum(),
            false => DVec3::Z * view.right.z.signum(),
        };
        let grain = grain(view.pixel * view.depth(centre).abs());
        let way = (axis * half * 2.0 * BESIDE / grain).round() * grain;
        let changes = file.changed(&copy.centre_path(), |i, number| number + way[i]);
        let text = edit::set(&text, &changes).ok_or(NOT_IN_TEXT)?;
        self.document.change(text, None)?;
        self.picked = Some(copy);
        Ok(())
    }

    /// Puts the camera into the file.
    ///
    /// # Errors
    /// A value that the scene file does not take, or that the camera moves.
    pub fn set_camera(&mut self, camera: &Camera) -> Result<(), String> {
        if self.document.scene.is_moved("camera") {
            return Err("the camera moves: its places are keys of a motion in the file".to_owned());
        }
        let (eye, look_at) = (camera.eye.as_dvec3(), camera.look_at.as_dvec3());
        let grain = grain(eye.distance(look_at) * CAMERA_GRAIN);
        // There is no -0 after this.
        let vector = |v: DVec3| json!(((v / grain).round() * grain + DVec3::ZERO).to_array());
        let changes = [
            ("camera.eye".to_owned(), vector(eye)),
            ("camera.look_at".to_owned(), vector(look_at)),
        ];
        self.set(&changes, None)
    }

    /// Goes back before the last step, or does it again.
    ///
    /// # Errors
    /// If there is no such step.
    pub fn undo(&mut self, again: bool) -> Result<(), String> {
        if !self.document.undo(again) {
            return Err("there is nothing more".to_owned());
        }
        self.forget_what_is_gone();
        Ok(())
    }

    /// Picks nothing if the picked object is not in the file any more.
    pub fn forget_what_is_gone(&mut self) {
        let is_there = |object: &Picked| self.document.scene.value(&object.path()).is_some();
        self.picked = self.picked.filter(is_there);
    }

    /// Takes the text with other values.
    fn set(&mut self, changes: &[(String, Value)], step: Option<Step>) -> Result<(), String> {
        let text = edit::set(self.document.text(), changes).ok_or(NOT_IN_TEXT)?;
        self.document.change(text, step)
    }
}

const NOTHING: &str = "no object is picked: click one";
const NOT_IN_TEXT: &str = "the place of that is not found in the file's text";

/// By how much of its distance a camera's place is rounded at most.
const CAMERA_GRAIN: f64 = 1e-3;

/// The power of ten that is at most half a length.
fn grain(length: f64) -> f64 {
    10_f64.powf((length * 0.5).log10().floor())
}

/// A length rounded to three digits, so that files stay readable: by less than a tenth of a notch.
fn three_digits(length: f64) -> f64 {
    format!("{length:.2e}").parse().unwrap_or(length)
}
