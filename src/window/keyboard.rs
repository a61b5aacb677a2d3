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
/// The whole screen.
pub(crate) const F: c_uint = b'f' as c_uint;
/// The window.
pub(crate) const W: c_uint = b'w' as c_uint;
/// No key.
pub(crate) const NONE: c_uint = 0xff_ffff;

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
    /// The key with this number when no other is held.
    pub(crate) fn of(key: c_uint) -> Option<Press> {
        const SLASH: c_uint = b'/' as c_uint;
        Some(match key {
            LEFT => Press::Left,
            RIGHT => Press::Right,
            HOME => Press::Home,
            SLASH | F1 => Press::Help,
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
