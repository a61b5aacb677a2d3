//! Errors of the server, and its end.

use core::{
    ffi::c_int,
    sync::atomic::{AtomicBool, Ordering::Relaxed},
};

use x11_dl::xlib;

use super::functions::Xlib;
use crate::line;

/// Set when the server no longer knows the window.
static CLOSED: AtomicBool = AtomicBool::new(false);

/// Whether the server no longer knows the window.
pub fn is_closed() -> bool {
    CLOSED.load(Relaxed)
}

/// Heeds errors from now on.
pub fn heed(x: Xlib) {
    // SAFETY: the functions have the signatures that Xlib calls them by, and stay.
    unsafe {
        (x.XSetErrorHandler)(refused);
        (x.XSetIOErrorHandler)(lost);
    }
}

/// Takes note if somebody destroyed the window. Xlib's own function would end the process.
///
/// Ignores what else the server refuses, such as a focus that can't be set yet: it does no harm.
unsafe extern "C" fn refused(_: *mut xlib::Display, error: *mut xlib::XErrorEvent) -> c_int {
    // SAFETY: Xlib hands over the error it got.
    let code = unsafe { (*error).error_code };
    if code == xlib::BadWindow || code == xlib::BadDrawable {
        CLOSED.store(true, Relaxed);
    }
    0
}

/// Ends the process when the connection to the display breaks: Xlib can't go on, nor return.
unsafe extern "C" fn lost(_: *mut xlib::Display) -> c_int {
    line::write(line::ERROR, b"eightfold: the display is gone\n");
    // SAFETY: nothing is left to be written or given back.
    unsafe { libc::_exit(1) }
}
