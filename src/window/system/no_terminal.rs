//! On Windows, frames are not shown in a console: windows are always available.

// Never opened; it only has to be a `RenderTarget`.
pub use crate::render_target::Headless as Terminal;

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

pub(crate) fn restore() {}
