//! Xcursor without its library.
//!
//! `minifb` loads eight pointer pictures at start and shows none of them until it is asked to. The
//! intro never asks: its pointer is the desktop's own, which `None` (0) stands for.

use core::ffi::{c_char, c_ulong};

use crate::{OpenError, xlib::Display};

#[derive(Clone, Copy)]
pub struct Xcursor {
    pub XcursorLibraryLoadCursor: unsafe extern "C" fn(*mut Display, *const c_char) -> c_ulong,
}

impl Xcursor {
    #[inline]
    pub fn open() -> Result<Xcursor, OpenError> {
        Ok(Xcursor {
            XcursorLibraryLoadCursor: no_cursor,
        })
    }
}

#[inline]
unsafe extern "C" fn no_cursor(_: *mut Display, _: *const c_char) -> c_ulong {
    0
}
