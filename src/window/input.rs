//! Input for interactive programs. The intro has five keys (Esc, F, H, Q, W) and does not link this
//! module.

use core::ffi::c_uint;

/// Key numbers are X11 keysyms on every system: letters and digits are their ASCII codes.
pub(crate) const ESCAPE: c_uint = 0xff1b;
pub(crate) const HOME: c_uint = 0xff50;
pub(crate) const LEFT: c_uint = 0xff51;
pub(crate) const RIGHT: c_uint = 0xff53;
pub(crate) const F1: c_uint = 0xffbe;
pub(crate) const H: c_uint = b'h' as c_uint;
pub(crate) const Q: c_uint = b'q' as c_uint;
pub(crate) const NONE: c_uint = 0xff_ffff;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Input {
    /// A key was pressed. [`Press::Left`] and [`Press::Right`] repeat while they are held.
    Key(Press),
    Mouse(Mouse),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mouse {
    pub action: Action,
    /// Pixels from the window's left edge; may be outside while a button is held.
    pub x: i32,
    /// Pixels from the window's upper edge.
    pub y: i32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    Down(Button),
    Up(Button),
    Move,
    /// The wheel was turned by this number of notches, away from the user if positive.
    Wheel(i32),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Button {
    Left,
    Middle,
    Right,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Press {
    /// Space, a digit from 1 to 9, or one of the letters c, e, h, p, s and v.
    Character(char),
    Left,
    Right,
    Home,
    /// `?` with or without Shift, or F1, which is on every keyboard.
    Help,
}

impl Press {
    pub(crate) fn repeats(self) -> bool {
        matches!(self, Press::Left | Press::Right)
    }

    pub(crate) fn of(key: c_uint) -> Option<Press> {
        Some(match key {
            LEFT => Press::Left,
            RIGHT => Press::Right,
            HOME => Press::Home,
            F1 => Press::Help,
            _ => match char::from_u32(key)? {
                '/' => Press::Help,
                key @ (' ' | '1'..='9' | 'c' | 'e' | 'h' | 'p' | 's' | 'v') => {
                    Press::Character(key)
                }
                _ => return None,
            },
        })
    }
}
