//! The intro's own window on an X display: no more than it takes, and frames in memory that the server shares.

use core::{
    ffi::{CStr, c_int},
    mem::zeroed,
};

use x11_dl::xlib;

use super::{
    blit::Frames,
    listener::Listener,
    x11::{self, Place, Toplevel, Xlib, keys},
};
use crate::{
    input::{self, Input},
    loading::why_not_loaded,
    screen::{Next, Screen},
};

/// A window that shows frames, with keys: F for the whole screen, W for the window, H for numbers over the
/// picture, Esc to end.
///
/// Its events are taken from Xlib, so that a key that is pressed and released between two frames counts. It stays until
/// the process ends, when the display closes it, at once and for sure.
pub struct Window {
    top: Toplevel,
    /// The message that a window manager sends instead of closing it.
    delete: xlib::Atom,
    size: (usize, usize),
    frames: Frames,
    /// When a key was let go last.
    released: xlib::Time,
    /// The listener that takes note of other keys and the mouse, once somebody listens.
    listener: Option<&'static mut Listener>,
}

/// The longest side of a window, in pixels: the X protocol has no more.
const MAX_SIDE: c_int = 32_767;

impl Window {
    /// Opens a window whose inside has a size in pixels.
    ///
    /// # Errors
    /// If there is no display to open it on: why not.
    pub fn open(title: &CStr, width: usize, height: usize) -> Result<Window, &'static str> {
        // Open the display.
        let x = Xlib::load().ok_or_else(why_not_loaded)?;
        let display = x11::open(x)?;
        // SAFETY: the display is open.
        let (top, frames) = unsafe {
            let screen = &*(x.XDefaultScreenOfDisplay)(display);
            let image = x11::picture(x, display);
            if (*image).red_mask == 0 {
                // Its pixels are numbers in a table of colours.
                return Err("X display without colours");
            }
            // Make a window of the least size, with memory for its frames.
            let window = (x.XCreateSimpleWindow)(display, screen.root, 0, 0, 1, 1, 0, 0, 0);
            let top = Toplevel::new(x, display, window);
            let frames = Frames::new(&top, image, screen.default_gc);
            (top, frames)
        };
        let mut window = Window {
            delete: top.atom(c"WM_DELETE_WINDOW"),
            top,
            size: (width, height),
            frames,
            released: 0,
            listener: None,
        };
        // Name it, and ask for its events.
        window.set_title(title);
        window.top.set_class();
        let Toplevel {
            display,
            window: id,
            ..
        } = window.top;
        // SAFETY: the window exists, and what is pointed to outlives the call.
        unsafe {
            let events = xlib::StructureNotifyMask | xlib::KeyPressMask | xlib::KeyReleaseMask;
            (x.XSelectInput)(display, id, events);
            (x.XSetWMProtocols)(display, id, &mut window.delete, 1);
        }
        // Show it in its size.
        window.place(width, height);
        // SAFETY: the display is open.
        unsafe { (x.XSync)(display, xlib::False) };
        Ok(window)
    }

    /// Names the window anew.
    pub fn set_title(&mut self, title: &CStr) {
        let Toplevel {
            x, display, window, ..
        } = self.top;
        // SAFETY: the window exists, and the title outlives the call.
        unsafe { (x.XStoreName)(display, window, title.as_ptr()) };
        let (name, kind) = (
            self.top.atom(c"_NET_WM_NAME"),
            self.top.atom(c"UTF8_STRING"),
        );
        self.top.set_text(name, kind, title.to_bytes());
    }

    /// Shows the window for the first time, with a size, in the middle of the screen if no window manager knows better.
    fn place(&self, width: usize, height: usize) {
        let (width, height) = (width as c_int, height as c_int);
        let (screen, _) = self.top.attributes(self.top.root);
        self.top.move_to(Place {
            x: c_int::max(screen.width - width, 0) / 2,
            y: c_int::max(screen.height - height, 0) / 2,
            width,
            height,
        });
    }

    /// Goes to the whole screen and hides the pointer, or back to the window where it was and as it was.
    pub fn set_fullscreen(&mut self, on: bool) {
        self.top.set_fullscreen(on);
    }
}

/// The functions for the lab's window.
impl Window {
    /// Listens to keys and the mouse from now on. The pointer is seen on the whole screen, too.
    pub fn listen(&mut self) {
        self.top.no_pointer = 0;
        self.listener = Some(Listener::start(&self.top));
    }

    /// Takes the input at the window since the last call, in order; nothing unless it [listens](Window::listen).
    pub fn inputs(&mut self) -> Vec<Input> {
        let listener = self.listener.as_mut();
        listener.map(|listener| listener.take()).unwrap_or_default()
    }
}

impl Screen for Window {
    fn size(&self) -> (usize, usize) {
        self.size
    }

    fn canvas(&mut self, width: usize, height: usize) -> &mut [u32] {
        self.frames.canvas(width, height)
    }

    fn show(&mut self) -> Next {
        // Show the frame.
        self.frames.show(&self.top, self.size);
        let (mut fullscreen, mut next) = (None, Next::GoOn);
        let Toplevel { x, display, .. } = self.top;
        if self.listener.is_none() {
            // Whoever watches a show touches no key.
            // SAFETY: the display is open.
            unsafe { (x.XResetScreenSaver)(display) };
        }
        // SAFETY: zero is a value of every field of an event, and which of its parts is there is told by its type.
        unsafe {
            // Read all events that have come.
            let mut event: xlib::XEvent = zeroed();
            while (x.XPending)(display) > 0 {
                (x.XNextEvent)(display, &mut event);
                // A key that is held is let go and pressed at the same time, again and again.
                let is_repeated = self.released == event.key.time;
                if let Some(listener) = &mut self.listener {
                    listener.hear(x, &event, is_repeated);
                }
                match event.type_ {
                    xlib::KeyRelease => self.released = event.key.time,
                    xlib::KeyPress => match keys::pressed(x, &event.key) {
                        input::ESCAPE => return Next::End(0),
                        keys::F => fullscreen = Some(true),
                        keys::W => fullscreen = Some(false),
                        input::H if !is_repeated => next = next.toggled(),
                        _ => {}
                    },
                    xlib::ConfigureNotify => {
                        // The server sends no other sizes, but anybody can send such an event.
                        let side = |length: c_int| length.clamp(1, MAX_SIDE) as usize;
                        self.size = (side(event.configure.width), side(event.configure.height));
                    }
                    xlib::ClientMessage
                        if event.client_message.data.get_long(0) as xlib::Atom == self.delete =>
                    {
                        return Next::End(0);
                    }
                    _ => {}
                }
            }
        }
        if x11::is_closed() {
            return Next::End(0);
        }
        if let Some(on) = fullscreen {
            self.set_fullscreen(on);
        }
        next
    }
}
