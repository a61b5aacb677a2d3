use core::ffi::c_int;
use core::sync::atomic::{AtomicBool, Ordering::Relaxed};

use x11_dl::xlib;

use super::functions::Xlib;
use crate::line;

/// Whether the window was destroyed.
static CLOSED: AtomicBool = AtomicBool::new(false);

pub fn is_closed() -> bool {
    CLOSED.load(Relaxed)
}

pub fn heed(x: Xlib) {
    // SAFETY: the functions have the signatures that Xlib expects.
    unsafe {
        (x.XSetErrorHandler)(refused);
        (x.XSetIOErrorHandler)(lost);
    }
}

/// Records that the window was destroyed: Xlib's own handler would end the process. Other errors do
/// no harm.
unsafe extern "C" fn refused(_: *mut xlib::Display, error: *mut xlib::XErrorEvent) -> c_int {
    // SAFETY: Xlib passes a valid error.
    let code = unsafe { (*error).error_code };
    if code == xlib::BadWindow || code == xlib::BadDrawable {
        CLOSED.store(true, Relaxed);
    }
    0
}

/// Ends the process when the connection breaks, since Xlib must not return.
unsafe extern "C" fn lost(_: *mut xlib::Display) -> c_int {
    line::write(line::ERROR, b"eightfold: X display is lost\n");
    // SAFETY: it may be called at any time.
    unsafe { libc::_exit(1) }
}
