//! What a key means, whatever alphabet is typed.

use core::ffi::{c_int, c_uint};

use super::{
    functions::Xlib,
    types::{ControlMask, Mod1Mask, Mod4Mask, XKeyEvent},
};
use crate::keyboard;

/// Modifiers that make a key a command to somebody else: Ctrl, Alt, and the one with the desktop's sign.
const COMMAND: c_uint = ControlMask | Mod1Mask | Mod4Mask;

/// The number of a key that was pressed, without Shift: by the layout, of several the one that is in use. Where that has no
/// Latin letter, as those of other alphabets, it is the one in the same place on a keyboard of the USA. [`keyboard::NONE`] with
/// Ctrl or Alt.
pub fn pressed(x: Xlib, event: &XKeyEvent) -> c_uint {
    if event.state & COMMAND != 0 {
        return keyboard::NONE;
    }
    let layout = ((event.state >> 13) & 3) as c_int;
    // SAFETY: the event's display is open.
    let key =
        unsafe { (x.XkbKeycodeToKeysym)(event.display, event.keycode as u8, layout, 0) } as c_uint;
    if (b'a'.into()..=b'z'.into()).contains(&key) {
        return key;
    }
    // Places have these numbers on every Linux.
    let letter = match event.keycode {
        25 => b'w',
        26 => b'e',
        33 => b'p',
        39 => b's',
        41 => b'f',
        43 => b'h',
        61 => b'/',
        _ => return key,
    };
    letter.into()
}
