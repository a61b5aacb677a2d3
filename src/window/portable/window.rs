//! A window by `minifb`.

use core::{
    ffi::{CStr, c_uint},
    mem::take,
};

use minifb::{ScaleMode, WindowOptions};

use super::{
    desktop::{Desktop, Display},
    memory::pixels,
    mouse::Mouse,
    typing::Typing,
};
use crate::{
    input::{self, Input},
    keyboard::{self, Press},
    screen::{Next, Screen},
};

/// A window that shows frames, with keys: F for the whole screen, W for the window, Esc to end.
pub struct Window {
    shown: minifb::Window,
    /// The functions that `minifb` lacks.
    desktop: Desktop,
    /// The frame to be drawn and shown next.
    frame: &'static mut [u32],
    /// Width and height of that one.
    drawn: (usize, usize),
    typing: Typing,
    /// The mouse, once somebody listens.
    mouse: Option<Mouse>,
    /// Input by other keys and the mouse that has not been asked for yet.
    inputs: Vec<Input>,
}

impl Window {
    /// Opens a window whose inside has a size in pixels.
    ///
    /// # Errors
    /// If there is no display to open it on: why not.
    pub fn open(title: &CStr, width: usize, height: usize) -> Result<Window, &'static str> {
        let display = Display::choose()?;
        let options = WindowOptions {
            resize: true,
            scale_mode: ScaleMode::Stretch,
            ..WindowOptions::default()
        };
        let name = title.to_string_lossy();
        let mut shown = display
            .open(|| minifb::Window::new(&name, width, height, options))
            .map_err(|_| display.why_not)?;
        // The intro has a pace of its own.
        shown.set_target_fps(0);
        let typing = Typing::default();
        shown.set_input_callback(Box::new(typing.clone()));
        Ok(Window {
            desktop: Desktop::of(display, &shown),
            shown,
            frame: pixels(),
            drawn: (0, 0),
            typing,
            mouse: None,
            inputs: Vec::new(),
        })
    }

    /// Names the window anew.
    pub fn set_title(&mut self, title: &CStr) {
        self.shown.set_title(&title.to_string_lossy());
    }

    /// Goes to the whole screen and hides the pointer, or back to the window where it was and as it was.
    pub fn set_fullscreen(&mut self, on: bool) {
        self.desktop.set_fullscreen(&mut self.shown, on);
        if self.mouse.is_some() {
            self.shown.set_cursor_visibility(true);
        }
    }
}

/// The functions for the lab's window.
impl Window {
    /// Listens to keys and the mouse from now on. The pointer is seen on the whole screen, too.
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
            input::push(&mut self.inputs, Input::Key(press));
        }
        mouse.ask(&self.shown, self.desktop.notch(), &mut self.inputs);
    }
}

impl Screen for Window {
    fn size(&self) -> (usize, usize) {
        // One that is minimised has none.
        let (width, height) = self.shown.get_size();
        (width.max(1), height.max(1))
    }

    fn canvas(&mut self, width: usize, height: usize) -> &mut [u32] {
        self.drawn = (width, height);
        &mut self.frame[..width * height]
    }

    fn show(&mut self) -> Next {
        // `minifb` would say so in words of its own.
        if let Some(code) = self.desktop.end() {
            return Next::End(code);
        }
        // Show the frame.
        let (width, height) = self.drawn;
        let frame = &mut self.frame[..width * height];
        self.desktop.colour(frame);
        let is_shown = self.shown.update_with_buffer(frame, width, height);
        // Take the keys that were pressed.
        let typed = self.typing.take();
        if !self.shown.is_active() {
            self.typing.release();
        }
        let keys = if self.desktop.has_typing() {
            typed
        } else {
            self.desktop.keys()
        };
        if let Some(code) = self.desktop.end() {
            return Next::End(code);
        }
        // End with the window.
        if !self.shown.is_open() {
            return Next::End(0);
        }
        if is_shown.is_err() {
            return Next::End(1);
        }
        // Do what the keys ask for.
        self.note(&keys);
        let (mut fullscreen, mut next) = (None, Next::GoOn);
        for key in keys {
            match key {
                keyboard::ESCAPE => return Next::End(0),
                keyboard::F => fullscreen = Some(true),
                keyboard::W => fullscreen = Some(false),
                keyboard::H => next = next.toggled(),
                _ => {}
            }
        }
        if let Some(on) = fullscreen {
            self.set_fullscreen(on);
        }
        next
    }
}
