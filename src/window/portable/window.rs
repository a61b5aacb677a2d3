//! A window by `minifb`.

use core::{
    ffi::{CStr, c_uint},
    mem::take,
};
use std::env;

use minifb::{ScaleMode, WindowOptions};

use super::{keys::Keys, memory::pixels, mouse::Mouse};
use crate::{
    input::{self, Input, Press},
    screen::{Next, Screen},
};

/// A window that shows frames, with keys: H for numbers over the picture, Esc to end. `minifb` has no fullscreen of its own; a
/// desktop's key or button may have.
pub struct Window {
    shown: minifb::Window,
    /// The frame to be drawn and shown next.
    frame: &'static mut [u32],
    /// Width and height of that one.
    drawn: (usize, usize),
    keys: Keys,
    /// The mouse, once somebody listens.
    mouse: Option<Mouse>,
    /// Input by other keys and the mouse that has not been asked for yet.
    inputs: Vec<Input>,
}

impl Window {
    /// Opens a window whose inside has a size in pixels.
    ///
    /// # Errors
    /// If there is no display to open it on.
    pub fn open(title: &CStr, width: usize, height: usize) -> Result<Window, &'static str> {
        // On X `minifb` fails where this names an input method that does not run.
        // SAFETY: no other thread of this crate's reads the environment.
        unsafe { env::remove_var("XMODIFIERS") };
        let options = WindowOptions {
            resize: true,
            scale_mode: ScaleMode::Stretch,
            ..WindowOptions::default()
        };
        let name = title.to_string_lossy();
        let mut shown = minifb::Window::new(&name, width, height, options)
            .map_err(|_| "no display for a window")?;
        // The intro has a pace of its own.
        shown.set_target_fps(0);
        let keys = Keys::default();
        shown.set_input_callback(Box::new(keys.clone()));
        Ok(Window {
            shown,
            frame: pixels(),
            drawn: (0, 0),
            keys,
            mouse: None,
            inputs: Vec::new(),
        })
    }

    /// Names the window anew.
    pub fn set_title(&mut self, title: &CStr) {
        self.shown.set_title(&title.to_string_lossy());
    }

    /// Does nothing: `minifb` has no fullscreen.
    pub fn set_fullscreen(&mut self, _: bool) {}
}

/// The functions for the lab's window.
impl Window {
    /// Listens to keys and the mouse from now on.
    pub fn listen(&mut self) {
        self.mouse = Some(Mouse::default());
    }

    /// Takes the input at the window since the last call, in order; nothing unless it [listens](Window::listen).
    pub fn inputs(&mut self) -> Vec<Input> {
        take(&mut self.inputs)
    }

    /// Takes note of keys that the window itself has no use for, and of the mouse, for whoever listens.
    fn note(&mut self, keys: &[c_uint]) {
        let Some(mouse) = &mut self.mouse else {
            return;
        };
        for press in keys.iter().filter_map(|&key| Press::of(key)) {
            self.inputs.push(Input::Key(press));
        }
        mouse.ask(&self.shown, &mut self.inputs);
    }
}

impl Screen for Window {
    fn size(&self) -> (usize, usize) {
        // A minimised window has none.
        let (width, height) = self.shown.get_size();
        (width.max(1), height.max(1))
    }

    fn canvas(&mut self, width: usize, height: usize) -> &mut [u32] {
        self.drawn = (width, height);
        &mut self.frame[..width * height]
    }

    fn show(&mut self) -> Next {
        // Show the frame.
        let (width, height) = self.drawn;
        let frame = &self.frame[..width * height];
        let is_shown = self.shown.update_with_buffer(frame, width, height);
        // End with the window.
        if !self.shown.is_open() {
            return Next::End(0);
        }
        if is_shown.is_err() {
            return Next::End(1);
        }
        // Do what the keys ask for.
        let keys = self.keys.take();
        self.note(&keys);
        let mut next = Next::GoOn;
        for key in keys {
            match key {
                input::ESCAPE => return Next::End(0),
                input::H => next = next.toggled(),
                _ => {}
            }
        }
        next
    }
}
