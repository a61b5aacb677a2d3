//! Keys, as edges: a tap counts even if press and release arrive together.

use core::cell::Cell;

use minifb::{InputCallback, Key};

/// What the viewer wants, by the keys pressed since it was last asked.
#[derive(Clone, Copy, Default)]
pub(crate) struct Wishes {
    /// Esc: end the show.
    pub end: bool,
    /// The whole screen (F) or a window (W), whichever was pressed last.
    pub fullscreen: Option<bool>,
}

/// Collects wishes between two frames. The window's own `is_key_pressed` knows only what is still
/// down once all events are taken.
#[derive(Clone, Copy)]
pub(crate) struct Keyboard {
    wishes: &'static Cell<Wishes>,
}

impl Keyboard {
    /// For a window that stays as long as the process.
    pub fn new() -> Keyboard {
        Keyboard {
            wishes: Box::leak(Box::default()),
        }
    }

    /// The wishes since the last call.
    pub fn take(&self) -> Wishes {
        self.wishes.take()
    }
}

impl InputCallback for Keyboard {
    fn add_char(&mut self, _: u32) {}

    fn set_key_state(&mut self, key: Key, down: bool) {
        let mut wishes = self.wishes.get();
        match key {
            _ if !down => {}
            Key::Escape => wishes.end = true,
            Key::F => wishes.fullscreen = Some(true),
            Key::W => wishes.fullscreen = Some(false),
            _ => {}
        }
        self.wishes.set(wishes);
    }
}
