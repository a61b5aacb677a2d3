//! A console of Windows is no screen: it always has windows beside it.

use crate::screen::{Next, Screen};

/// The terminal on standard output, of which there is none.
pub enum Terminal {}

impl Terminal {
    /// Takes over the terminal on standard output, if there is one.
    #[must_use]
    pub fn open() -> Option<Terminal> {
        None
    }

    /// Whether standard output is a terminal that [`Terminal::open`] takes over.
    #[must_use]
    pub fn is_there() -> bool {
        false
    }
}

impl Screen for Terminal {
    fn size(&self) -> (usize, usize) {
        match *self {}
    }

    fn canvas(&mut self, _: usize, _: usize) -> &mut [u32] {
        match *self {}
    }

    fn show(&mut self) -> Next {
        match *self {}
    }
}

/// Gives the terminal back, if it was taken.
pub(crate) fn restore() {}
