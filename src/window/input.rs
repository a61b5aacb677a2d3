//! Input at a window by the keyboard and the mouse, for programs that are worked with, as the lab's viewer is.
//!
//! The intro hears Esc, F, H and W alone, and does not listen to this: its file has no code for it.

use core::ffi::c_uint;

/// Keys have the numbers of X11 (`keysym`) on every system: letters and digits are their ASCII codes.
pub(crate) const ESCAPE: c_uint = 0xff1b;
/// To the beginning.
pub(crate) const HOME: c_uint = 0xff50;
/// The arrow to the left.
pub(crate) const LEFT: c_uint = 0xff51;
/// The arrow to the right.
pub(crate) const RIGHT: c_uint = 0xff53;
/// F1.
pub(crate) const F1: c_uint = 0xffbe;
/// The numbers over the picture.
pub(crate) const H: c_uint = b'h' as c_uint;
/// No key.
pub(crate) const NONE: c_uint = 0xff_ffff;

/// Something that was done at the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Input {
    /// A key was pressed. [`Press::Left`] and [`Press::Right`] come again and again while they are held.
    Key(Press),
    /// Something was done with the mouse.
    Mouse(Mouse),
}

/// An action of the mouse, and where it was.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mouse {
    /// The action.
    pub action: Action,
    /// Pixels of the window, from its left edge; beyond the window while a button is held there.
    pub x: i32,
    /// Pixels of the window, from its upper edge.
    pub y: i32,
}

/// The actions of a mouse.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    /// A button was pressed.
    Down(Button),
    /// A button was let go.
    Up(Button),
    /// The pointer was moved.
    Move,
    /// The wheel was turned by so many notches, away from the hand if positive.
    Wheel(i32),
}

/// A button of the mouse.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Button {
    /// The left one, for right hands.
    Left,
    /// The middle one, or the wheel.
    Middle,
    /// The right one, for right hands.
    Right,
}

/// A key that the lab listens to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Press {
    /// Space, or one of 1 to 9 and the lower-case letters c, e, h, p, s and v.
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

impl Press {
    /// Whether it comes again while it is held.
    pub(crate) fn repeats(self) -> bool {
        matches!(self, Press::Left | Press::Right)
    }

    /// The key with this number.
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
