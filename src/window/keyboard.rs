//! Keys, as edges: a tap counts even if press and release arrive together.

use core::cell::Cell;
#[cfg(feature = "keys")]
use std::cell::RefCell;

use minifb::{InputCallback, Key};

/// What the viewer wants, by the keys pressed since it was last asked.
#[derive(Clone, Copy, Default)]
pub(crate) struct Wishes {
    /// Esc: end the show.
    pub end: bool,
    /// The whole screen (F) or a window (W), whichever was pressed last.
    pub fullscreen: Option<bool>,
}

/// A key that the lab listens to.
#[cfg(feature = "keys")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Press {
    /// Space, or one of 1 to 9 and the lower-case letters e, h, p and s.
    Character(char),
    /// The arrow to the left.
    Left,
    /// The arrow to the right.
    Right,
    /// To the beginning.
    Home,
    /// `?`, with or without Shift, or F1, which is on every keyboard.
    Help,
}

#[cfg(feature = "keys")]
impl Press {
    fn of(key: Key) -> Option<Press> {
        const DIGITS: [Key; 9] = [
            Key::Key1,
            Key::Key2,
            Key::Key3,
            Key::Key4,
            Key::Key5,
            Key::Key6,
            Key::Key7,
            Key::Key8,
            Key::Key9,
        ];
        Some(match key {
            Key::Left => Press::Left,
            Key::Right => Press::Right,
            Key::Home => Press::Home,
            Key::Slash | Key::F1 => Press::Help,
            Key::Space => Press::Character(' '),
            Key::E => Press::Character('e'),
            Key::H => Press::Character('h'),
            Key::P => Press::Character('p'),
            Key::S => Press::Character('s'),
            key => {
                let (_, digit) = DIGITS.into_iter().zip('1'..).find(|&(k, _)| k == key)?;
                Press::Character(digit)
            }
        })
    }
}

/// Collects wishes between two frames. The window's own `is_key_pressed` knows only what is still
/// down once all events are taken.
#[derive(Clone, Copy)]
pub(crate) struct Keyboard {
    wishes: &'static Cell<Wishes>,
    /// What was pressed beside.
    #[cfg(feature = "keys")]
    presses: &'static RefCell<Vec<Press>>,
}

impl Keyboard {
    /// For a window that stays as long as the process.
    pub fn new() -> Keyboard {
        Keyboard {
            wishes: Box::leak(Box::default()),
            #[cfg(feature = "keys")]
            presses: Box::leak(Box::default()),
        }
    }

    /// The wishes since the last call.
    pub fn take(&self) -> Wishes {
        self.wishes.take()
    }

    /// What else was pressed since the last call, in order.
    #[cfg(feature = "keys")]
    pub fn take_presses(&self) -> Vec<Press> {
        self.presses.take()
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
        #[cfg(feature = "keys")]
        if down {
            self.presses.borrow_mut().extend(Press::of(key));
        }
    }
}
