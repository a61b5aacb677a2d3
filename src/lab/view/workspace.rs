//! The workspace: a scene by name or one that is edited, through its own camera or one that is moved by hand; and what keys and
//! the mouse do with it.

use super::camera::{self, View};
use super::document::{Document, News};
use super::editor::{Drag, Editor};
use super::objects::Picked;
use crate::arguments::Size;
use crate::scenes::SceneName;
use eightfold_oracle::Oracle;
use eightfold_tracer::glam::{DVec2, dvec2};
use eightfold_tracer::scene::{Camera, Scene};
use eightfold_window::input::{Action, Button, Press};

/// A scene, and what is being done with it.
pub struct Workspace {
    name: SceneName,
    /// The scene file, if it is one.
    pub editor: Option<Editor>,
    /// The camera if it was moved by hand.
    camera: Option<Camera>,
    /// How often it was moved.
    moves: u64,
    hand: Hand,
    /// The notice to show, until the next input.
    pub notice: Option<String>,
    /// The mistake in the file on the disk.
    pub fault: Option<String>,
}

/// The purpose for which the mouse is held.
enum Hand {
    Free,
    /// Turning the camera; the last place of the pointer.
    Orbit(DVec2),
    /// Moving the camera.
    Pan(DVec2),
    /// Dragging an object, pressed at a place; nothing moves until the pointer has left that.
    Drag(Box<Drag>, Option<DVec2>),
}

/// The time in seconds and the size in pixels of the picture that the mouse is over.
#[derive(Clone, Copy)]
pub struct Shown {
    pub time: f32,
    pub size: Size,
}

/// Something done with the mouse at a place of the picture.
#[derive(Clone, Copy)]
pub struct Gesture {
    pub action: Action,
    pub at: DVec2,
    pub is_shifted: bool,
}

/// How many pixels the pointer may tremble in a click.
const TREMOR: f64 = 3.0;

/// Half a turn of the camera is a drag over the whole height of the picture.
const RADIANS_PER_HEIGHT: f64 = std::f64::consts::PI;

impl Workspace {
    /// A scene by its name. A scene file is read for editing.
    ///
    /// # Errors
    /// The mistake in the file.
    pub fn open(name: SceneName) -> Result<Self, String> {
        let editor = match name {
            SceneName::File(file) => Some(Editor::new(Document::open(&file.name)?)),
            _ => None,
        };
        Ok(Self {
            name,
            editor,
            camera: None,
            moves: 0,
            hand: Hand::Free,
            notice: None,
            fault: None,
        })
    }

    /// The scene at a time in seconds, as it is seen.
    pub fn scene(&self, time: f32) -> Scene {
        let mut scene = match &self.editor {
            Some(editor) => editor.document.scene.at(time),
            None => self.name.at(time),
        };
        if let Some(camera) = self.camera {
            scene.camera = camera;
        }
        scene
    }

    /// The scene's length in seconds.
    pub fn length(&self) -> f32 {
        let editor = self.editor.as_ref();
        editor.map_or(self.name.length(), |editor| editor.document.scene.length)
    }

    /// Is another one after each change of the scene and of the camera.
    pub fn version(&self) -> [u64; 2] {
        let editor = self.editor.as_ref();
        [
            editor.map_or(0, |editor| editor.document.version),
            self.moves,
        ]
    }

    /// Whether there are changes that are not saved.
    pub fn is_unsaved(&self) -> bool {
        let editor = self.editor.as_ref();
        editor.is_some_and(|editor| !editor.document.is_saved())
    }

    /// Tells what is left at the end; `None` if nothing was written.
    pub fn left_behind(&mut self) -> Option<String> {
        self.editor.as_mut()?.document.left_behind()
    }

    /// Looks whether the file has changed, and keeps what is not saved in a file of its own.
    pub fn look(&mut self) {
        let Some(editor) = &mut self.editor else {
            return;
        };
        let news = editor.document.look();
        if let Hand::Drag(..) = self.hand
            && editor.document.held().is_none()
        {
            self.hand = Hand::Free;
        }
        match news {
            None => {}
            Some(News::Faulty(why)) => self.fault = Some(why),
            Some(News::Read) => self.fault = None,
            Some(News::ReadOver(path)) => {
                self.fault = None;
                let path = path.display();
                let what = "The file has changed and was read again; Ctrl-Z brings back what was not saved";
                self.notice = Some(format!("{what}, which is in {path}, too."));
            }
        }
        editor.forget_what_is_gone();
        editor.document.follow();
    }

    /// Does what a key asks for. Returns false if it asks for nothing here.
    pub fn press(&mut self, press: Press, shown: Shown) -> bool {
        if press == Press::Character('v') {
            self.camera = None;
            self.moves += 1;
            self.notice = None;
            return true;
        }
        let scene = self.scene(shown.time);
        let told = self.notice.take();
        let Some(editor) = &mut self.editor else {
            return false;
        };
        let done = match press {
            Press::Character('m') => editor.next_material(),
            Press::Character('c') => editor.set_camera(&scene.camera).map(|()| {
                self.camera = None;
                self.moves += 1;
            }),
            Press::Delete => editor.delete(),
            Press::Control('d') => editor.duplicate(&scene, &View::of(&scene.camera, shown.size)),
            Press::Control('z') => editor.undo(false),
            Press::Control('y') => editor.undo(true),
            Press::Control('s') => {
                let saved = editor.document.save(told.as_deref());
                saved.map(|()| self.fault = None)
            }
            _ => return false,
        };
        self.notice = done.err();
        true
    }

    /// Does what the mouse asks for.
    pub fn point(&mut self, gesture: Gesture, shown: Shown) {
        let Gesture { action, at, .. } = gesture;
        match action {
            Action::Down(Button::Left) => self.pick(at, shown),
            Action::Down(Button::Middle) => self.hand = Hand::Pan(at),
            Action::Down(Button::Right) => self.hand = Hand::Orbit(at),
            Action::Up(_) => {
                self.draw_hand(gesture, shown);
                self.hand = Hand::Free;
                if let Some(editor) = &mut self.editor {
                    editor.document.end_step();
                }
            }
            Action::Move => self.draw_hand(gesture, shown),
            Action::Wheel(notches) => self.turn_wheel(f64::from(notches), at, shown),
        }
    }

    /// The object at a place of the picture.
    fn object_at(&self, at: DVec2, shown: Shown) -> Option<Picked> {
        let scene = self.scene(shown.time);
        let quality = eightfold_tracer::Quality::EXHAUSTIVE;
        let Size { width, height } = shown.size;
        let oracle = Oracle::new(&scene, &quality, width, height);
        Picked::of(oracle.object_at(at.x.floor() as isize, at.y.floor() as isize))
    }

    /// Picks the object at a place, and begins to drag it; else the camera is turned.
    fn pick(&mut self, at: DVec2, shown: Shown) {
        self.hand = Hand::Orbit(at);
        let object = self.object_at(at, shown);
        let scene = self.scene(shown.time);
        let Some(editor) = &mut self.editor else {
            return;
        };
        let was_picked = editor.picked == object;
        editor.picked = object;
        // A floor is easily dragged by mistake.
        let is_held = object.is_some_and(|object| was_picked || !object.is_plane());
        let view = View::of(&scene.camera, shown.size);
        if is_held && let Some(drag) = editor.drag(&scene, &view, at) {
            self.hand = Hand::Drag(Box::new(drag), Some(at));
        }
    }

    /// Goes on with what the mouse is held for.
    fn draw_hand(&mut self, gesture: Gesture, shown: Shown) {
        let at = gesture.at;
        match &mut self.hand {
            Hand::Free => {}
            Hand::Orbit(last) => {
                let by = (at - *last) * (RADIANS_PER_HEIGHT / shown.size.height as f64);
                *last = at;
                self.move_camera(shown, |camera| camera::orbit(camera, by.x, by.y));
            }
            Hand::Pan(last) => {
                let by = at - *last;
                *last = at;
                self.move_camera(shown, |camera| camera::pan(camera, shown.size, by));
            }
            Hand::Drag(drag, start) => {
                if start.is_some_and(|start| (at - start).abs().max_element() < TREMOR) {
                    return;
                }
                *start = None;
                if let Some(editor) = &mut self.editor {
                    let its_own = || editor.document.scene.at(shown.time).camera;
                    let camera = self.camera.unwrap_or_else(its_own);
                    let view = View::of(&camera, shown.size);
                    let moved = editor.drag_on(drag, &view, at, gesture.is_shifted);
                    self.notice = moved.err();
                }
            }
        }
    }

    /// Resizes the picked object if the pointer is over it, else moves the camera.
    fn turn_wheel(&mut self, notches: f64, at: DVec2, shown: Shown) {
        let object = self.object_at(at, shown);
        match &mut self.editor {
            Some(editor) if object.is_some() && editor.picked == object => {
                self.notice = editor.resize(notches).err();
            }
            _ => self.move_camera(shown, |camera| camera::zoom(camera, notches)),
        }
    }

    /// Moves the camera by hand. One that can't be drawn by is not taken.
    fn move_camera(&mut self, shown: Shown, change: impl FnOnce(&mut Camera)) {
        let mut scene = self.scene(shown.time);
        let before = scene.camera;
        change(&mut scene.camera);
        if scene.camera != before && scene.validate().is_ok() {
            self.camera = Some(scene.camera);
            self.moves += 1;
        }
    }
}

impl Gesture {
    /// Whether something else begins with it.
    pub fn is_new(&self) -> bool {
        matches!(self.action, Action::Down(_) | Action::Wheel(_))
    }

    /// Something done at a pixel of a window, whose picture may have another size.
    pub fn new(mouse: eightfold_window::input::Mouse, window: (usize, usize), size: Size) -> Self {
        let place = |at: i32, window: usize, size: usize| {
            (f64::from(at) + 0.5) * size as f64 / window.max(1) as f64
        };
        Self {
            action: mouse.action,
            at: dvec2(
                place(mouse.x, window.0, size.width),
                place(mouse.y, window.1, size.height),
            ),
            is_shifted: mouse.is_shifted,
        }
    }
}
