//! On Windows, frames are not shown in a console: windows are always available.

use crate::render_target::{Next, RenderTarget};

/// The terminal on standard output, which does not exist.
pub enum Terminal {}

impl Terminal {
    #[must_use]
    pub fn open() -> Option<Terminal> {
        None
    }

    #[must_use]
    pub fn is_there() -> bool {
        false
    }

    /// Windows converts text for its consoles.
    #[must_use]
    pub fn is_utf8() -> bool {
        true
    }
}

impl RenderTarget for Terminal {
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

pub(crate) fn restore() {}
