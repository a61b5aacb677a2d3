//! The meaning of keys, whatever alphabet is typed.

use core::ffi::{c_int, c_uint};

use x11_dl::xlib::{ControlMask, Mod1Mask, Mod4Mask, XKeyEvent};

use super::functions::Xlib;
use crate::keyboard;

/// The whole screen.
pub const F: c_uint = b'f' as c_uint;
/// The window.
pub const W: c_uint = b'w' as c_uint;

/// Modifiers that make a key a command to somebody else: Ctrl, Alt, and the one with the desktop's sign.
const COMMAND: c_uint = ControlMask | Mod1Mask | Mod4Mask;

/// The number of a key that was pressed, without Shift: by the layout, of several the one that is in use. Where that has no
/// Latin letter, as those of other alphabets, F, H and W are those in the same place on a keyboard of the USA. [`keyboard::NONE`]
/// with Ctrl or Alt.
pub fn pressed(x: Xlib, event: &XKeyEvent) -> c_uint {
    if event.state & COMMAND != 0 {
        return keyboard::NONE;
    }
    let key = by_layout(x, event);
    if is_letter(key) {
        return key;
    }
    // Places have these numbers on every Linux.
    match event.keycode {
        25 => W,
        41 => F,
        43 => keyboard::H,
        _ => key,
    }
}

/// The number of a key that was pressed, without Shift, and with [`keyboard::CONTROL`] if Ctrl is held. Where the layout in use has
/// no Latin letter, it is that in the same place on a keyboard of the USA. [`keyboard::NONE`] with Alt.
pub fn typed(x: Xlib, event: &XKeyEvent) -> c_uint {
    let control = match event.state & COMMAND {
        0 => 0,
        command if command == ControlMask => keyboard::CONTROL,
        _ => return keyboard::NONE,
    };
    let key = by_layout(x, event);
    let place = PLACES.iter().find(|(place, _)| *place == event.keycode);
    let key = match place {
        Some(&(_, letter)) if !is_letter(key) => letter.into(),
        _ => key,
    };
    control | key
}

/// The places of letters on a keyboard of the USA, and that of `?`, which have these numbers on every Linux.
const PLACES: [(c_uint, u8); 14] = [
    (25, b'w'),
    (26, b'e'),
    (29, b'y'),
    (33, b'p'),
    (39, b's'),
    (40, b'd'),
    (41, b'f'),
    (43, b'h'),
    (46, b'l'),
    (52, b'z'),
    (54, b'c'),
    (55, b'v'),
    (58, b'm'),
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
