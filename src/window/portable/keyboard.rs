use std::{cell::RefCell, ffi::c_uint, mem::take, rc::Rc};

use minifb::{InputCallback, Key};

use crate::input::{self, Press};

/// Keys pressed since the last call of [`KeyQueue::take`], recorded by `minifb`'s callback.
#[derive(Clone, Default)]
pub struct KeyQueue(Rc<RefCell<State>>);

#[derive(Default)]
struct State {
    pressed: Vec<c_uint>,
    held: Vec<Key>,
}

impl KeyQueue {
    pub fn take(&self) -> Vec<c_uint> {
        take(&mut self.0.borrow_mut().pressed)
    }
}

impl InputCallback for KeyQueue {
    fn add_char(&mut self, _: u32) {}

    fn set_key_state(&mut self, key: Key, is_down: bool) {
        let State { pressed, held } = &mut *self.0.borrow_mut();
        if !is_down {
            held.retain(|&other| other != key);
            return;
        }
        let number = number(key);
        let is_held = held.contains(&key);
        if !is_held {
            held.push(key);
        }
        if !is_held || Press::of(number).is_some_and(Press::repeats) {
            pressed.push(number);
        }
    }
}

/// `minifb` numbers digits and letters consecutively.
fn number(key: Key) -> c_uint {
    let character = match (key, key as u8) {
        (Key::Escape, _) => return input::ESCAPE,
        (Key::Home, _) => return input::HOME,
        (Key::Left, _) => return input::LEFT,
        (Key::Right, _) => return input::RIGHT,
        (Key::F1, _) => return input::F1,
        (Key::Space, _) => b' ',
        (Key::Slash, _) => b'/',
        (_, digit @ 0..10) => b'0' + digit,
        (_, letter @ 10..36) => b'a' + letter - 10,
        _ => return input::NONE,
    };
    character.into()
}
