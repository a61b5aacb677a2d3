//! The keys that the intro hears.

use core::ffi::c_uint;

use x11_dl::xlib::XKeyEvent;

use crate::{
    keyboard,
    x11::{
        Xlib,
        keys::{COMMAND, by_layout, is_letter},
    },
};

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
        25 => keyboard::W,
        41 => keyboard::F,
        43 => keyboard::H,
        _ => key,
    }
}
