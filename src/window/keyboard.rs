//! Keys by number, and those that the lab listens to.

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
