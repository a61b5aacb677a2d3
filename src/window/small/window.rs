use core::ffi::{CStr, c_int, c_uint};
use core::mem::{take, zeroed};
use core::ptr::null_mut;

use x11_dl::xlib;

use super::blit::Frames;
use super::listener::{BASIC, EVENTS, Note, note};
use super::x11::{self, Place, Toplevel, keyboard};
use crate::input::{self, Input};
use crate::loading::why_not_loaded;
use crate::render_target::{InnerSize, Next, RenderTarget, fit};

/// For the intro's help.
pub const KEYS: &str = "F fullscreen, W window, H hud, Esc or Q quit";

/// A key that is pressed and released between two frames counts.
pub struct Window {
    top: Toplevel,
    delete: xlib::Atom,
    size: (usize, usize),
    frames: Frames,
    released: xlib::Time,
    frame_number: u8,
    listener: Option<(Note, &'static mut Vec<Input>)>,
}

/// Frames between two looks at the monitor: a quarter of a second. Each look waits for the server
/// four times.
const LOOK: u8 = 16;

/// The height of a window's title bar in common window managers, rounded up.
const TITLE_BAR: c_int = 32;

/// The maximum side of a window in the X protocol.
const MAX_SIDE: c_int = 32_767;

impl Window {
    /// Opens a window, or returns the reason for a failure.
    pub fn open(title: &CStr, size: InnerSize) -> Result<Window, &'static str> {
        let (size, shrinks) = size.parts();
        let x = x11::XLIB.open().ok_or_else(why_not_loaded)?;
        let display = x11::open(x)?;
        // SAFETY: the display is open.
        let (top, frames) = unsafe {
            let screen = &*(x.XDefaultScreenOfDisplay)(display);
            let (visual, depth) = (screen.root_visual, screen.root_depth as c_uint);
            // A header without pixels.
            let format = xlib::ZPixmap;
            let image =
                (x.XCreateImage)(display, visual, depth, format, 0, null_mut(), 1, 1, 32, 0);
            if (*image).red_mask == 0 {
                // The display's pixels are palette indices.
                return Err("X display lacks colours");
            }
            let window = (x.XCreateSimpleWindow)(display, screen.root, 0, 0, 1, 1, 0, 0, 0);
            let top = Toplevel::new(x, display, window);
            let frames = Frames::new(&top, image, screen.default_gc);
            (top, frames)
        };
        let mut window = Window {
            delete: top.atom(c"WM_DELETE_WINDOW"),
            top,
            size,
            frames,
            released: 0,
            frame_number: 0,
            listener: None,
        };
        window.set_title(title);
        window.top.set_program();
        let Toplevel { display, window: id, .. } = window.top;
        window.top.select(BASIC);
        // SAFETY: the window exists, and the atom outlives the call.
        unsafe { (x.XSetWMProtocols)(display, id, &mut window.delete, 1) };
        window.place(shrinks);
        // SAFETY: the display is open.
        unsafe { (x.XSync)(display, xlib::False) };
        Ok(window)
    }

    pub fn set_title(&mut self, title: &CStr) {
        let Toplevel { x, display, window, .. } = self.top;
        let (kind, text) = (self.top.atom(c"UTF8_STRING"), title.to_bytes());
        // SAFETY: the window exists, and the title outlives the calls.
        unsafe {
            (x.XStoreName)(display, window, title.as_ptr());
            self.top.set(c"_NET_WM_NAME", kind, 8, text.as_ptr(), text.len());
        }
    }

    /// Shows the window in the centre of the first monitor, unless the window manager moves it.
    fn place(&mut self, shrinks: bool) {
        // No monitor shows this point.
        let monitor = self.top.monitor(-1, -1);
        if shrinks {
            let bar = if self.top.is_managed() { TITLE_BAR } else { 0 };
            let height = c_int::max(monitor.height - bar, 1);
            self.size = fit(self.size, (monitor.width as usize, height as usize));
        }
        let (width, height) = (self.size.0 as c_int, self.size.1 as c_int);
        self.top.move_to(Place {
            x: monitor.x + c_int::max(monitor.width - width, 0) / 2,
            y: monitor.y + c_int::max(monitor.height - height, 0) / 2,
            width,
            height,
        });
    }

    /// Makes the window cover its monitor, without a pointer, or restores it.
    pub fn set_fullscreen(&mut self, on: bool) {
        self.top.set_fullscreen(on);
    }

    pub fn listen(&mut self) {
        self.top.no_pointer = 0;
        self.top.select(EVENTS);
        self.listener = Some((note, Box::leak(Box::default())));
    }

    pub fn inputs(&mut self) -> Vec<Input> {
        self.listener.as_mut().map(|(_, inputs)| take(*inputs)).unwrap_or_default()
    }
}

impl RenderTarget for Window {
    fn size(&self) -> (usize, usize) {
        self.size
    }

    fn canvas(&mut self, width: usize, height: usize) -> &mut [u32] {
        self.frames.canvas(width, height)
    }

    fn show(&mut self) -> Next {
        self.frames.show(&self.top, self.size);
        let (mut fullscreen, mut next) = (None, Next::GoOn);
        let Toplevel { x, display, .. } = self.top;
        if self.listener.is_none() {
            // Viewers of a show press no keys, so keep the screen on.
            // SAFETY: the display is open.
            unsafe { (x.XResetScreenSaver)(display) };
        }
        // SAFETY: zero is valid for all fields of an event, and the type tells its valid part.
        unsafe {
            let mut event: xlib::XEvent = zeroed();
            while (x.XPending)(display) > 0 {
                (x.XNextEvent)(display, &mut event);
                // A held key sends pairs of releases and presses with equal times.
                let is_repeated = self.released == event.key.time;
                if let Some((note, inputs)) = &mut self.listener {
                    note(inputs, x, &event, is_repeated);
                }
                match event.type_ {
                    xlib::KeyRelease => self.released = event.key.time,
                    xlib::KeyPress => match keyboard::pressed(x, &event.key) {
                        input::ESCAPE | input::Q => return Next::End(0),
                        keyboard::F => fullscreen = Some(true),
                        keyboard::W => fullscreen = Some(false),
                        input::H if !is_repeated => next = next.toggled(),
                        _ => {}
                    },
                    xlib::ConfigureNotify => {
                        // Any program can send such an event with another size.
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
        self.frame_number = self.frame_number.wrapping_add(1);
        if self.frame_number.is_multiple_of(LOOK) {
            self.top.follow_monitor();
        }
        next
    }
}
