//! Linux: X11 by Xlib, with what the window managers understand; and Wayland, where there is no X.

use core::ffi::{c_uint, c_ulong};
use core::mem::zeroed;
use std::env;

use raw_window_handle::{HasWindowHandle, RawWindowHandle};
use x11_dl::xlib;

use super::wayland;
use crate::{
    line,
    loading::why_not_loaded,
    x11::{self, Toplevel, Xlib},
};

/// The variable that names the Wayland display.
const WAYLAND_DISPLAY: &str = "WAYLAND_DISPLAY";

/// The variable that names the input method of X, a program that makes characters of several keys.
const INPUT_METHOD: &str = "XMODIFIERS";

/// A display that `minifb` opens a window on.
pub struct Display {
    /// Why there is no window if it can't.
    pub why_not: &'static str,
    /// That of X; without it the display is Wayland's.
    x: Option<X>,
}

/// A connection to an X server of this crate's own, beside that of `minifb`: what comes by it `minifb` does not take away.
struct X {
    x: Xlib,
    display: *mut xlib::Display,
    /// The bits of a pixel of the server's that are red, green and blue.
    masks: [c_ulong; 3],
}

impl Display {
    /// Chooses the display: X if it can be opened, where the way back from the whole screen leads to the same window on every
    /// desktop, else Wayland's. Or says why there is none.
    pub fn choose() -> Result<Display, &'static str> {
        let has_wayland = env::var_os(WAYLAND_DISPLAY).is_some_and(|name| !name.is_empty());
        match X::open() {
            Ok(x) => {
                // `minifb` would take the first, and crashes where the second names what is not there. Keys come without either.
                for variable in [WAYLAND_DISPLAY, INPUT_METHOD] {
                    // SAFETY: no other thread of this crate's runs before there is a window.
                    unsafe { env::remove_var(variable) };
                }
                Ok(Display {
                    why_not: "no X display",
                    x: Some(x),
                })
            }
            Err(_) if has_wayland => Ok(Display {
                why_not: "no Wayland display",
                x: None,
            }),
            Err(why) => Err(why),
        }
    }
}

impl Display {
    /// Has `minifb` open a window on it. On Wayland it tells standard output what the desktop lacks, where the report is to be.
    pub fn open<T>(&self, window: impl FnOnce() -> T) -> T {
        if self.x.is_some() {
            return window();
        }
        // SAFETY: the path outlives the call. What is a copy of standard output is put back in its place and closed.
        unsafe {
            let output = libc::dup(line::OUTPUT);
            let nowhere = libc::open(c"/dev/null".as_ptr(), libc::O_WRONLY | libc::O_CLOEXEC);
            libc::dup2(nowhere, line::OUTPUT);
            libc::close(nowhere);
            let opened = window();
            libc::dup2(output, line::OUTPUT);
            libc::close(output);
            opened
        }
    }
}

impl X {
    fn open() -> Result<X, &'static str> {
        let x = Xlib::load().ok_or_else(why_not_loaded)?;
        let display = x11::open(x)?;
        // SAFETY: the display is open, and the picture is one.
        let picture = unsafe { &*x11::picture(x, display) };
        if picture.bits_per_pixel != 32 {
            // `minifb` has no other pixels.
            return Err("X display without pixels of 32 bits");
        }
        let masks = x11::masks(picture);
        Ok(X { x, display, masks })
    }
}

/// The functions for a window that `minifb` lacks.
pub enum Desktop {
    /// On X, with the [masks](X::masks).
    X(Toplevel, [c_ulong; 3]),
    /// On Wayland.
    Wayland(wayland::Window),
}

impl Desktop {
    /// That of a window.
    ///
    /// # Panics
    /// If `minifb` did not open it on that display.
    pub fn of(display: Display, window: &minifb::Window) -> Desktop {
        let id = window.window_handle().map(|handle| handle.as_raw());
        if let (Some(X { x, display, masks }), Ok(RawWindowHandle::Xlib(id))) = (display.x, &id) {
            // SAFETY: display and window stay open as long as `minifb`'s window, which this is a part of.
            let top = unsafe {
                (x.XSelectInput)(display, id.window, xlib::KeyPressMask);
                Toplevel::new(x, display, id.window)
            };
            top.set_class();
            return Desktop::X(top, masks);
        }
        let window = wayland::Window::of(window);
        Desktop::Wayland(window.expect("minifb has opened it on the display that was chosen"))
    }

    /// Whether `minifb` tells the keys. It knows no layout but the first on X.
    pub fn has_typing(&self) -> bool {
        matches!(self, Desktop::Wayland(_))
    }

    /// Makes a frame one by the server's own colours.
    pub fn colour(&self, frame: &mut [u32]) {
        if let Desktop::X(_, masks) = self
            && *masks != x11::MASKS
        {
            for pixel in frame {
                *pixel = x11::with_masks(*pixel, *masks);
            }
        }
    }

    /// The keys that were pressed, where [`Desktop::has_typing`] does not hold.
    pub fn keys(&mut self) -> Vec<c_uint> {
        let mut keys = Vec::new();
        if let Desktop::X(top, _) = self {
            // SAFETY: zero is a value of every field of an event, and which of its parts is there is told by its type.
            unsafe {
                while (top.x.XPending)(top.display) > 0 {
                    let mut event: xlib::XEvent = zeroed();
                    (top.x.XNextEvent)(top.display, &mut event);
                    if event.type_ == xlib::KeyPress {
                        keys.push(x11::typed(top.x, &event.key));
                    }
                }
            }
        }
        keys
    }

    /// The number that `minifb` gives for a notch of the wheel away from the hand.
    pub fn notch(&self) -> f32 {
        match self {
            // A notch is a button that is pressed and let go, of which each counts.
            Desktop::X(..) => 2.0,
            // Downwards is positive, by as many pixels as compositors scroll.
            Desktop::Wayland(_) => -10.0,
        }
    }

    /// The exit code if the window is lost.
    pub fn end(&self) -> Option<i32> {
        match self {
            Desktop::X(..) => x11::is_closed().then_some(0),
            Desktop::Wayland(window) if window.is_lost() => {
                line::write(line::ERROR, b"eightfold: the display is gone\n");
                Some(1)
            }
            Desktop::Wayland(_) => None,
        }
    }

    /// Goes to the whole screen and hides the pointer, or back to the window where it was and as it was. On Wayland a compositor
    /// that leaves the window's size to the program gets one as large as the screen was.
    pub fn set_fullscreen(&mut self, shown: &mut minifb::Window, on: bool) {
        match self {
            Desktop::X(top, _) => top.set_fullscreen(on),
            Desktop::Wayland(window) => {
                shown.set_cursor_visibility(!on);
                window.set_fullscreen(on);
            }
        }
    }
}
