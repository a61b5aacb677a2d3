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
