//! A window on an X display.

use core::{
    ffi::c_int,
    mem::{ManuallyDrop, forget},
    sync::atomic::{AtomicBool, Ordering::Relaxed},
};

use minifb::{Scale, WindowOptions};
use raw_window_handle::{HasDisplayHandle, HasWindowHandle, RawDisplayHandle, RawWindowHandle};
use x11_dl::xlib::{self, Xlib};

#[cfg(feature = "keys")]
pub use crate::keyboard::Press;
use crate::{
    blit::{self, Blit},
    fullscreen::Fullscreen,
    keyboard::Keyboard,
    line,
    screen::{Next, Screen},
    system::call,
};

/// A window that shows frames, with keys: F for the whole screen, W for the window, Esc to end.
pub struct Window {
    /// Never dropped: the display closes the window when the process ends, at once and for sure.
    window: ManuallyDrop<minifb::Window>,
    keyboard: Keyboard,
    fullscreen: Fullscreen,
    blit: Blit,
}

/// Why there is no window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoWindow {
    /// libX11 is not installed.
    NoLibrary,
    /// There is no display, or it has no window for us.
    NoDisplay,
}

/// Set when the server no longer knows the window.
static CLOSED: AtomicBool = AtomicBool::new(false);

impl Window {
    /// Opens a window whose inside has a size in pixels.
    ///
    /// # Errors
    /// If there is no display to open it on.
    pub fn open(title: &str, width: usize, height: usize) -> Result<Window, NoWindow> {
        let x = Xlib::open().map_err(|_| NoWindow::NoLibrary)?;
        // SAFETY: the functions have the signatures that Xlib calls them by, and stay.
        unsafe {
            (x.XSetErrorHandler)(refused);
            (x.XSetIOErrorHandler)(lost);
        }
        let options = WindowOptions {
            resize: true,
            scale: Scale::X1,
            ..WindowOptions::default()
        };
        let mut window = match minifb::Window::new(title, width, height, options) {
            Ok(window) => ManuallyDrop::new(window),
            Err(why) => {
                forget(why);
                return Err(NoWindow::NoDisplay);
            }
        };
        let (display, handle) = handles(&window).ok_or(NoWindow::NoDisplay)?;
        // The caller keeps the time.
        window.set_target_fps(0);
        let keyboard = Keyboard::new();
        window.set_input_callback(Box::new(keyboard));
        Ok(Window {
            keyboard,
            fullscreen: Fullscreen::new(x, display, handle),
            blit: Blit::new(x, display, handle),
            window,
        })
    }

    /// Goes to the whole screen, or back to the window where it was and as it was.
    pub fn set_fullscreen(&mut self, on: bool) {
        if on {
            self.fullscreen.enter();
        } else {
            self.fullscreen.leave();
        }
    }
}

/// What the lab asks of its window.
#[cfg(feature = "keys")]
impl Window {
    /// The keys pressed since the last call, in order; one that is held comes again and again.
    pub fn presses(&mut self) -> Vec<Press> {
        self.keyboard.take_presses()
    }

    /// Names the window anew. The title must not hold a NUL.
    pub fn set_title(&mut self, title: &str) {
        self.window.set_title(title);
    }
}

impl Screen for Window {
    fn size(&self) -> (usize, usize) {
        self.window.get_size()
    }

    fn canvas(&mut self, width: usize, height: usize) -> &mut [u32] {
        self.blit.canvas(width, height)
    }

    fn show(&mut self) -> Next {
        self.blit.show(self.window.get_size());
        self.window.update();
        self.fullscreen.keep();
        let wishes = self.keyboard.take();
        if wishes.end || !self.window.is_open() || CLOSED.load(Relaxed) {
            return Next::End(0);
        }
        if let Some(on) = wishes.fullscreen {
            self.set_fullscreen(on);
        }
        Next::GoOn
    }
}

/// Xlib's names for a window and its display.
fn handles(window: &minifb::Window) -> Option<(*mut xlib::Display, xlib::Window)> {
    let display = window.display_handle().ok()?.as_raw();
    let window = window.window_handle().ok()?.as_raw();
    let (RawDisplayHandle::Xlib(display), RawWindowHandle::Xlib(window)) = (display, window) else {
        return None;
    };
    Some((display.display?.as_ptr().cast(), window.window))
}

/// Takes note of requests that the server refuses. Xlib's own function would end the process.
///
/// The window is gone if somebody destroyed it. Of the rest, only whether memory can be shared matters;
/// a focus that can't be set yet does no harm.
unsafe extern "C" fn refused(_: *mut xlib::Display, error: *mut xlib::XErrorEvent) -> c_int {
    // SAFETY: Xlib hands over the error it got.
    let code = unsafe { (*error).error_code };
    let gone = code == xlib::BadWindow || code == xlib::BadDrawable;
    let flag = if gone { &CLOSED } else { &blit::REFUSED };
    flag.store(true, Relaxed);
    0
}

/// Ends the process when the connection to the display breaks: Xlib can't go on, nor return.
unsafe extern "C" fn lost(_: *mut xlib::Display) -> c_int {
    line::write(line::ERROR, b"eightfold: the display is gone\n");
    // SAFETY: nothing is left to be written or given back.
    unsafe { call!(SYS_exit_group, 1) };
    0
}
