//! Windows and keys, through Xlib.

mod errors;
mod fullscreen;
mod functions;
pub mod keyboard;

use core::ffi::{CStr, c_int, c_long, c_void};
use core::mem::zeroed;
use core::ptr::{null, null_mut, with_exposed_provenance_mut};
use core::sync::atomic::{AtomicU64, Ordering::Release};

use x11_dl::xlib;

pub use errors::is_closed;
pub use fullscreen::Place;
pub use functions::{XEXT, XLIB, Xext, Xlib};
pub use keyboard::typed;

use super::threads::spawn;
use crate::clock;

/// The display's address, 0 if it is missing, or [`ASKED`] until it answers.
static DISPLAY: AtomicU64 = AtomicU64::new(ASKED);
const ASKED: u64 = 1;

extern "C" fn connect(_: *mut c_void) -> *mut c_void {
    // SAFETY: `open` has loaded Xlib; null selects the environment's display.
    let display = XLIB.open().map_or(null_mut(), |x| unsafe { (x.XOpenDisplay)(null()) });
    DISPLAY.store(display.expose_provenance() as u64, Release);
    null_mut()
}

/// Opens the environment's display. A second thread connects, because a server may never answer.
pub fn open(x: Xlib) -> Result<*mut xlib::Display, &'static str> {
    errors::heed(x);
    // SAFETY: the thread uses no pointer.
    let thread = unsafe { spawn(connect, null_mut()) };
    if thread.is_none() {
        connect(null_mut());
    }
    let display = clock::wait_while(&DISPLAY, ASKED);
    if display == ASKED {
        return Err("X display does not answer");
    }
    if let Some(thread) = thread {
        thread.join();
    }
    match display {
        0 => Err("X display is missing"),
        display => Ok(with_exposed_provenance_mut(display as usize)),
    }
}

pub struct Toplevel {
    pub x: Xlib,
    pub display: *mut xlib::Display,
    pub window: xlib::Window,
    pub root: xlib::Window,
    /// The pointer in fullscreen: an invisible one, or 0 for the desktop's own.
    pub no_pointer: xlib::Cursor,
    before: Option<Place>,
}

impl Toplevel {
    /// Prepares an existing window.
    ///
    /// # Safety
    /// Display and window have to stay open.
    pub unsafe fn new(x: Xlib, display: *mut xlib::Display, window: xlib::Window) -> Toplevel {
        // SAFETY: the caller guarantees the window; zero is a valid colour, and pointers outlive
        // the calls.
        unsafe {
            let dot = (x.XCreateBitmapFromData)(display, window, c"".as_ptr(), 1, 1);
            let mut colour: xlib::XColor = zeroed();
            let colour = &raw mut colour;
            Toplevel {
                x,
                display,
                window,
                root: (*(x.XDefaultScreenOfDisplay)(display)).root,
                no_pointer: (x.XCreatePixmapCursor)(display, dot, dot, colour, colour, 0, 0),
                before: None,
            }
        }
    }

    pub fn select(&self, events: c_long) {
        // SAFETY: the window exists.
        unsafe { (self.x.XSelectInput)(self.display, self.window, events) };
    }

    pub fn atom(&self, name: &CStr) -> xlib::Atom {
        // SAFETY: the display is open, and the name outlives the call.
        unsafe { (self.x.XInternAtom)(self.display, name.as_ptr(), xlib::False) }
    }

    /// Sets a property to `count` items of `bits` bits.
    ///
    /// # Safety
    /// The items have to be at `start`; Xlib keeps 32-bit ones in `c_long`.
    pub unsafe fn set(
        &self,
        name: &CStr,
        kind: xlib::Atom,
        bits: c_int,
        start: *const u8,
        count: usize,
    ) {
        let (display, window, name) = (self.display, self.window, self.atom(name));
        let (replace, count) = (xlib::PropModeReplace, count as c_int);
        // SAFETY: the window exists; the rest is required of the caller.
        unsafe {
            (self.x.XChangeProperty)(display, window, name, kind, bits, replace, start, count)
        };
    }

    /// Sets class, machine and process: desktops find rules by the class, and may end a process
    /// that hangs.
    pub fn set_program(&self) {
        let mut class = xlib::XClassHint {
            res_name: c"eightfold".as_ptr().cast_mut(),
            res_class: c"Eightfold".as_ptr().cast_mut(),
        };
        let (display, window, nothing) = (self.display, self.window, null());
        // SAFETY: the window exists, and pointers outlive the calls.
        unsafe {
            let describe = self.x.XSetWMProperties;
            describe(display, window, nothing, nothing, nothing, 0, nothing, nothing, &mut class);
            let process: c_long = libc::syscall(libc::SYS_getpid);
            let process = (&raw const process).cast();
            self.set(c"_NET_WM_PID", xlib::XA_CARDINAL, 32, process, 1);
        }
    }
}
