//! The meaning of keys, whatever alphabet is typed.

use core::ffi::{c_int, c_uint};

use x11_dl::xlib::{ControlMask, Mod1Mask, Mod4Mask, XKeyEvent};

use super::functions::Xlib;
use crate::input;

/// The whole screen.
pub const F: c_uint = b'f' as c_uint;
/// The window.
pub const W: c_uint = b'w' as c_uint;

/// Modifiers that make a key a command to somebody else: Ctrl, Alt, and the one with the desktop's sign.
const COMMAND: c_uint = ControlMask | Mod1Mask | Mod4Mask;

/// The number of a key that was pressed, without Shift: by the layout, of several the one that is in use. Where that has no
/// Latin letter, as those of other alphabets, F, H and W are those in the same place on a keyboard of the USA. [`input::NONE`]
/// with Ctrl or Alt.
pub fn pressed(x: Xlib, event: &XKeyEvent) -> c_uint {
    if event.state & COMMAND != 0 {
        return input::NONE;
    }
    let key = by_layout(x, event);
    if is_letter(key) {
        return key;
    }
    // Places have these numbers on every Linux.
    match event.keycode {
        25 => W,
        41 => F,
        43 => input::H,
        _ => key,
    }
}

/// Like [`pressed`], and all keys of [`Press`](crate::input::Press) are in the same place on a keyboard of the USA where the
/// layout has no Latin letter.
pub fn typed(x: Xlib, event: &XKeyEvent) -> c_uint {
    let key = pressed(x, event);
    match PLACES.iter().find(|(place, _)| *place == event.keycode) {
        Some(&(_, letter)) if key != input::NONE && !is_letter(key) => letter.into(),
        _ => key,
    }
}

/// The places of letters other than F, H and W on a keyboard of the USA, and of `?`.
const PLACES: [(c_uint, u8); 6] = [
    (26, b'e'),
    (33, b'p'),
    (39, b's'),
    (54, b'c'),
    (55, b'v'),
    (61, b'/'),
];

/// The number that the layout in use gives a key.
fn by_layout(x: Xlib, event: &XKeyEvent) -> c_uint {
    let layout = ((event.state >> 13) & 3) as c_int;
    // SAFETY: the event's display is open.
    unsafe { (x.XkbKeycodeToKeysym)(event.display, event.keycode as u8, layout, 0) as c_uint }
}

/// Whether a key's number is that of a Latin letter.
fn is_letter(key: c_uint) -> bool {
    (b'a'.into()..=b'z'.into()).contains(&key)
}
