//! Images in shared memory (MIT-SHM), through libXext.

#![allow(non_snake_case, reason = "Xlib's own names")]

use core::ffi::{c_int, c_uint};

use x11_dl::{
    xlib::{Bool, Display, Drawable, GC, Status, XImage},
    xshm::XShmSegmentInfo,
};

use crate::loading::{Table, loaded};

loaded! {
    Xext, NAMES:
    fn XShmAttach(*mut Display, *mut XShmSegmentInfo) -> Status;
    fn XShmQueryExtension(*mut Display) -> Bool;
    fn XShmPutImage(*mut Display, Drawable, GC, *mut XImage, c_int, c_int, c_int, c_int, c_uint, c_uint, Bool) -> Status;
}

static TABLE: Table<Xext> = Table::new();

impl Xext {
    /// Loads libXext at the first call.
    pub fn load() -> Option<&'static Xext> {
        TABLE.open(c"libXext.so.6", NAMES)
    }
}
