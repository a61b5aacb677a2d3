//! Keys beyond the intro's, for the lab.

use core::ffi::c_uint;

use x11_dl::keysym;

/// A key that the lab listens to.
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

impl Press {
    /// The key with this `keysym` when no other is held.
    pub(crate) fn of(key: c_uint) -> Option<Press> {
        Some(match key {
            keysym::XK_Left => Press::Left,
            keysym::XK_Right => Press::Right,
            keysym::XK_Home => Press::Home,
            keysym::XK_slash | keysym::XK_F1 => Press::Help,
            _ => Press::Character(
                char::from_u32(key).filter(|character| " 123456789ehps".contains(*character))?,
            ),
        })
    }
}
