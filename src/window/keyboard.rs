//! What a key means, whatever alphabet is typed; and keys beyond the intro's, for the lab.

use core::ffi::{c_int, c_uint};

use x11_dl::{
    keysym,
    xlib::{self, Functions},
};

/// Modifiers that make a key a command to somebody else: Ctrl, Alt, and the one with the desktop's sign.
const COMMAND: c_uint = xlib::ControlMask | xlib::Mod1Mask | xlib::Mod4Mask;

/// The `keysym` of a key that was pressed, without Shift: by the layout, of several the one that is in use. Where that has no
/// Latin letter, as those of other alphabets, it is the one in the same place on a keyboard of the USA. `XK_VoidSymbol` with Ctrl
/// or Alt.
pub(crate) fn pressed(x: Functions, event: &xlib::XKeyEvent) -> c_uint {
    if event.state & COMMAND != 0 {
        return keysym::XK_VoidSymbol;
    }
    let layout = ((event.state >> 13) & 3) as c_int;
    // SAFETY: the event's display is open.
    let key =
        unsafe { (x.XkbKeycodeToKeysym)(event.display, event.keycode as u8, layout, 0) } as c_uint;
    if (b'a'.into()..=b'z'.into()).contains(&key) {
        return key;
    }
    // Places have these numbers on every Linux.
    match event.keycode {
        25 => keysym::XK_w,
        26 => keysym::XK_e,
        33 => keysym::XK_p,
        39 => keysym::XK_s,
        41 => keysym::XK_f,
        43 => keysym::XK_h,
        61 => keysym::XK_slash,
        _ => key,
    }
}

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
            _ => Press::Character(char::from_u32(key).filter(|character| {
                matches!(character, ' ' | '1'..='9' | 'e' | 'h' | 'p' | 's')
            })?),
        })
    }
}

/// The first 32 keys of those that were pressed: as many as anybody presses while a frame is drawn.
#[derive(Default)]
pub(crate) struct Presses {
    keys: [Option<Press>; 32],
    count: usize,
}

impl Presses {
    /// Adds a key, if there is room.
    pub(crate) fn push(&mut self, press: Press) {
        if let Some(place) = self.keys.get_mut(self.count) {
            *place = Some(press);
            self.count += 1;
        }
    }

    /// The keys, in order.
    pub(crate) fn into_iter(self) -> impl Iterator<Item = Press> {
        self.keys.into_iter().flatten()
    }
}
