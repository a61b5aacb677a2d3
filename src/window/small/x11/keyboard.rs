use core::ffi::{c_int, c_uint};

use x11_dl::xlib::{ControlMask, Mod1Mask, Mod4Mask, XKeyEvent};

use super::functions::Xlib;
use crate::input;

pub const F: c_uint = b'f' as c_uint;
pub const W: c_uint = b'w' as c_uint;

/// Modifiers that make a key another program's command.
const COMMAND: c_uint = ControlMask | Mod1Mask | Mod4Mask;

/// Returns the keysym without Shift, by the current layout. F, H, Q and W are at their US positions
/// if the layout has no Latin letter there. With Ctrl, Alt or Super the result is [`input::NONE`].
pub fn pressed(x: Xlib, event: &XKeyEvent) -> c_uint {
    if event.state & COMMAND != 0 {
        return input::NONE;
    }
    let layout = ((event.state >> 13) & 3) as c_int;
    // SAFETY: the event's display is open.
    let key = unsafe { (x.XkbKeycodeToKeysym)(event.display, event.keycode as u8, layout, 0) };
    let key = key as c_uint;
    if is_letter(key) {
        return key;
    }
    match event.keycode {
        24 => input::Q,
        25 => W,
        41 => F,
        43 => input::H,
        _ => key,
    }
}

/// Like [`pressed`], but with US positions for all keys of [`Press`](crate::input::Press).
pub fn typed(x: Xlib, event: &XKeyEvent) -> c_uint {
    let key = pressed(x, event);
    match PLACES.iter().find(|(place, _)| *place == event.keycode) {
        Some(&(_, letter)) if key != input::NONE && !is_letter(key) => letter.into(),
        _ => key,
    }
}

const PLACES: [(c_uint, u8); 6] =
    [(26, b'e'), (33, b'p'), (39, b's'), (54, b'c'), (55, b'v'), (61, b'/')];

fn is_letter(key: c_uint) -> bool {
    (b'a'.into()..=b'z'.into()).contains(&key)
}
