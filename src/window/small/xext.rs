//! Images in shared memory (MIT-SHM), and monitors.

#![allow(non_snake_case, reason = "Xlib's own names")]

use core::ffi::{c_int, c_uint};

use x11_dl::{xinerama::XineramaScreenInfo, xlib::*, xshm::XShmSegmentInfo};

use crate::loading::loaded;

loaded! {
    static XEXT: Xext = c"libXext.so.6";
    fn XShmAttach(*mut Display, *mut XShmSegmentInfo) -> Status;
    fn XShmQueryExtension(*mut Display) -> Bool;
    fn XShmPutImage(*mut Display, Drawable, GC, *mut XImage, c_int, c_int, c_int, c_int, c_uint, c_uint, Bool) -> Status;
}

loaded! {
    static XINERAMA: Xinerama = c"libXinerama.so.1";
    fn XineramaIsActive(*mut Display) -> Bool;
    fn XineramaQueryScreens(*mut Display, *mut c_int) -> *mut XineramaScreenInfo;
}
