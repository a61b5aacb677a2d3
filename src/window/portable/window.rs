use core::ffi::{CStr, c_uint};
use core::mem::take;
use std::env;

use minifb::{ScaleMode, WindowOptions};

use super::{keyboard::KeyQueue, memory::pixels, mouse::Mouse};
use crate::input::{self, Input, Press};
use crate::render_target::{InnerSize, Next, RenderTarget};

pub const KEYS: &str = "H hud, Esc or Q quit";

/// `minifb` has no fullscreen; the desktop may have one.
pub struct Window {
    window: minifb::Window,
    frame: &'static mut [u32],
    frame_size: (usize, usize),
    keys: KeyQueue,
    mouse: Option<Mouse>,
    inputs: Vec<Input>,
}

impl Window {
    pub fn open(title: &CStr, size: InnerSize) -> Result<Window, &'static str> {
        let ((width, height), _) = size.parts();
        // On X `minifb` fails if this variable names an input method that is not running.
        // SAFETY: no other thread of this crate reads the environment.
        unsafe { env::remove_var("XMODIFIERS") };
        let options = WindowOptions {
            resize: true,
            scale_mode: ScaleMode::Stretch,
            ..WindowOptions::default()
        };
        let name = title.to_string_lossy();
        let mut window =
            minifb::Window::new(&name, width, height, options).map_err(|_| "display is missing")?;
        // The intro paces its frames itself.
        window.set_target_fps(0);
        let keys = KeyQueue::default();
        window.set_input_callback(Box::new(keys.clone()));
        Ok(Self { window, frame: pixels(), frame_size: (0, 0), keys, mouse: None, inputs: vec![] })
    }

    pub fn set_title(&mut self, title: &CStr) {
        self.window.set_title(&title.to_string_lossy());
    }

    pub fn set_fullscreen(&mut self, _: bool) {}

    pub fn listen(&mut self) {
        self.mouse = Some(Mouse::default());
    }

    pub fn inputs(&mut self) -> Vec<Input> {
        take(&mut self.inputs)
    }

    fn note(&mut self, keys: &[c_uint]) {
        let Some(mouse) = &mut self.mouse else {
            return;
        };
        for press in keys.iter().filter_map(|&key| Press::of(key)) {
            self.inputs.push(Input::Key(press));
        }
        mouse.poll(&self.window, &mut self.inputs);
    }
}

impl RenderTarget for Window {
    fn size(&self) -> (usize, usize) {
        let (width, height) = self.window.get_size();
        (width.max(1), height.max(1))
    }

    fn canvas(&mut self, width: usize, height: usize) -> &mut [u32] {
        self.frame_size = (width, height);
        &mut self.frame[..width * height]
    }

    fn show(&mut self) -> Next {
        let (width, height) = self.frame_size;
        let frame = &self.frame[..width * height];
        let is_shown = self.window.update_with_buffer(frame, width, height);
        if !self.window.is_open() {
            return Next::End(0);
        }
        if is_shown.is_err() {
            return Next::End(1);
        }
        let keys = self.keys.take();
        self.note(&keys);
        let mut next = Next::GoOn;
        for key in keys {
            match key {
                input::ESCAPE | input::Q => return Next::End(0),
                input::H => next = next.toggled(),
                _ => {}
            }
        }
        next
    }
}
