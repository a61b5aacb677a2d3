//! Keys as `minifb` hears of them.
//!
//! It names some systems' keys by their place and others' by their letter, and tells the character that was typed beside it.

use std::{cell::RefCell, ffi::c_uint, mem::take, rc::Rc};

use minifb::{InputCallback, Key};

use crate::keyboard;

/// The text that was typed since it was last asked for. It has two owners: the window and `minifb`.
#[derive(Clone, Default)]
pub struct Typing(Rc<RefCell<State>>);

#[derive(Default)]
struct State {
    /// How many modifiers are held that make a key a command to somebody else: Alt, and the one with the desktop's sign.
    commands: usize,
    /// How many Ctrl keys are held.
    controls: usize,
    /// Letters by the character, where a Latin one was typed.
    characters: Vec<c_uint>,
    /// Letters by the key, which count where no Latin character was typed.
    letters: Vec<c_uint>,
    /// Keys that are no letters.
    others: Vec<c_uint>,
}

/// The letters that are typed with the keys of F, W and H where the alphabet is Russian, Greek, Hebrew or Arabic.
const PLACES: [(char, u8); 11] = [
    ('\u{430}', b'f'),
    ('\u{446}', b'w'),
    ('\u{3c6}', b'f'),
    ('\u{3c2}', b'w'),
    ('\u{5db}', b'f'),
    ('\u{628}', b'f'),
    ('\u{635}', b'w'),
    ('\u{440}', b'h'),
    ('\u{3b7}', b'h'),
    ('\u{5d9}', b'h'),
    ('\u{627}', b'h'),
];

impl InputCallback for Typing {
    fn add_char(&mut self, character: u32) {
        let mut state = self.0.borrow_mut();
        // With Ctrl the key counts, and not the character.
        let is_text = state.commands == 0 && state.controls == 0;
        let Some(character) = char::from_u32(character).filter(|_| is_text) else {
            return;
        };
        let letter = character.to_ascii_lowercase();
        if letter.is_ascii_lowercase() {
            state.characters.push(letter.into());
        } else if let Some(&(_, key)) = PLACES.iter().find(|(typed, _)| *typed == character) {
            state.letters.push(key.into());
        } else if character == '?' {
            state.others.push(b'/'.into());
        }
    }

    fn set_key_state(&mut self, key: Key, is_down: bool) {
        let mut state = self.0.borrow_mut();
        if let Some(held) = state.modifiers(key) {
            *held = if is_down {
                *held + 1
            } else {
                held.saturating_sub(1)
            };
        } else if is_down && state.commands == 0 {
            match number(key) {
                keyboard::NONE => {}
                key if state.controls > 0 => state.others.push(key | keyboard::CONTROL),
                letter @ 0x61..=0x7a => state.letters.push(letter),
                other => state.others.push(other),
            }
        }
    }
}

impl Typing {
    /// The numbers of the keys that were pressed since the last call.
    pub fn take(&self) -> Vec<c_uint> {
        let mut state = self.0.borrow_mut();
        let mut keys = take(&mut state.others);
        let (characters, letters) = (take(&mut state.characters), take(&mut state.letters));
        keys.extend(if characters.is_empty() {
            letters
        } else {
            characters
        });
        keys
    }

    /// Forgets what modifiers are held: while another window has the keyboard, nobody tells when they are let go.
    pub fn release(&self) {
        let mut state = self.0.borrow_mut();
        (state.commands, state.controls) = (0, 0);
    }
}

impl State {
    /// The count that a key is a part of if it is a modifier.
    fn modifiers(&mut self, key: Key) -> Option<&mut usize> {
        use Key::{LeftAlt, LeftCtrl, LeftSuper, RightAlt, RightCtrl, RightSuper};
        match key {
            LeftCtrl | RightCtrl => Some(&mut self.controls),
            LeftAlt | LeftSuper | RightAlt | RightSuper => Some(&mut self.commands),
            _ => None,
        }
    }
}

/// The number of a key: a digit's and a letter's from their places in `minifb`'s list, which has them in order.
fn number(key: Key) -> c_uint {
    let character = match (key, key as u8) {
        (Key::Escape, _) => return keyboard::ESCAPE,
        (Key::Home, _) => return keyboard::HOME,
        (Key::Left, _) => return keyboard::LEFT,
        (Key::Right, _) => return keyboard::RIGHT,
        (Key::F1, _) => return keyboard::F1,
        (Key::Delete, _) => return keyboard::DELETE,
        (Key::Space, _) => b' ',
        (Key::Slash, _) => b'/',
        (_, digit @ 0..10) => b'0' + digit,
        (_, letter @ 10..36) => b'a' + letter - 10,
        _ => return keyboard::NONE,
    };
    character.into()
}

#[cfg(test)]
mod tests {
    use super::Typing;
    use crate::keyboard;
    use minifb::{InputCallback, Key};

    /// The letters that are heard when keys are pressed that give characters.
    fn heard(presses: &[(Option<Key>, Option<char>)]) -> String {
        let mut typing = Typing::default();
        for &(key, character) in presses {
            if let Some(key) = key {
                typing.set_key_state(key, true);
            }
            if let Some(character) = character {
                typing.add_char(character.into());
            }
        }
        let letters = typing.take();
        letters.into_iter().filter_map(char::from_u32).collect()
    }

    #[test]
    fn a_latin_character_counts_and_without_one_the_key() {
        assert_eq!(heard(&[(Some(Key::F), Some('f'))]), "f");
        assert_eq!(heard(&[(Some(Key::F), Some('F'))]), "f", "with Shift");
        assert_eq!(heard(&[(Some(Key::Z), Some('w'))]), "w", "France");
        assert_eq!(heard(&[(Some(Key::F), Some('\u{430}'))]), "ff", "Russia");
        assert_eq!(heard(&[(None, Some('\u{446}'))]), "w", "Russia, by letters");
        assert_eq!(heard(&[(Some(Key::Key1), Some('&'))]), "1", "France");
    }

    #[test]
    fn commands_to_others_are_not_heard() {
        let control = (Some(Key::LeftCtrl), None);
        assert_eq!(heard(&[control, (Some(Key::F), Some('\u{6}'))]), "");
        let mut typing = Typing::default();
        typing.set_key_state(Key::RightCtrl, true);
        typing.set_key_state(Key::Z, true);
        typing.set_key_state(Key::RightCtrl, false);
        assert_eq!(typing.take(), [u32::from(b'z') | keyboard::CONTROL]);
        typing.set_key_state(Key::LeftAlt, true);
        typing.set_key_state(Key::F, true);
        typing.set_key_state(Key::LeftAlt, false);
        typing.set_key_state(Key::W, true);
        assert_eq!(typing.take(), [u32::from(b'w')]);
        typing.set_key_state(Key::LeftAlt, true);
        typing.release();
        typing.set_key_state(Key::W, true);
        assert_eq!(typing.take(), [u32::from(b'w')], "Alt was let go elsewhere");
    }
}
