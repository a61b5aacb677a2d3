//! A window on an X display.

use core::{
    ffi::{CStr, c_int, c_uint},
    mem::{ManuallyDrop, take, zeroed},
    ptr::null_mut,
    sync::atomic::{AtomicBool, Ordering::Relaxed},
};

use minifb::{Scale, WindowOptions};
use raw_window_handle::{HasDisplayHandle, HasWindowHandle, RawDisplayHandle, RawWindowHandle};
use x11_dl::{
    keysym,
    xlib::{self, Functions},
};

pub use crate::keyboard::Press;
use crate::{
    blit::PutImage,
    fullscreen::Place,
    keyboard::{Presses, pressed},
    line,
    screen::{Next, Screen},
};

/// A window that shows frames, with keys: F for the whole screen, W for the window, Esc to end.
///
/// `minifb` makes it. What happens in it is taken from Xlib, so that a key that is pressed and released between two frames
/// counts. It stays until the process ends, when the display closes it, at once and for sure.
pub struct Window {
    pub(crate) x: Functions,
    pub(crate) display: *mut xlib::Display,
    pub(crate) window: xlib::Window,
    pub(crate) root: xlib::Window,
    /// What a window manager sends instead of closing it.
    delete: xlib::Atom,
    pub(crate) size: (usize, usize),
    /// A pointer without a picture.
    pub(crate) no_pointer: xlib::Cursor,
    /// Where the window was before it was placed over the screen.
    pub(crate) before: Option<Place>,
    pub(crate) context: xlib::GC,
    /// What Xlib knows of a picture; made to fit each one.
    pub(crate) image: *mut xlib::XImage,
    /// How pixels come to the window.
    pub(crate) put_image: PutImage,
    /// Two frames; the first is the one to be drawn and shown next.
    pub(crate) frames: [&'static mut [u32]; 2],
    /// Width and height of that one.
    pub(crate) drawn: (usize, usize),
    /// Other keys that were pressed since they were last asked for.
    presses: Presses,
    /// `minifb`'s own. It is not dropped, for it would give back a picture that the stand-in for Xlib never made.
    _made: ManuallyDrop<minifb::Window>,
}

/// Why there is no window on a computer without a desktop.
const NO_DISPLAY: &str = "no X display";

/// The longest side of a window, in pixels: the X protocol has no more.
const MAX_SIDE: c_int = 32_767;

/// Set when the server no longer knows the window.
static CLOSED: AtomicBool = AtomicBool::new(false);

impl Window {
    /// Opens a window whose inside has a size in pixels.
    ///
    /// # Errors
    /// If there is no display to open it on: why not.
    pub fn open(title: &CStr, width: usize, height: usize) -> Result<Window, &'static str> {
        let x = Functions::load().ok_or_else(x11_dl::why_not_loaded)?;
        // SAFETY: the functions have the signatures that Xlib calls them by, and stay.
        unsafe {
            (x.XSetErrorHandler)(refused);
            (x.XSetIOErrorHandler)(lost);
        }
        let made = ManuallyDrop::new(make(title).ok_or(NO_DISPLAY)?);
        let (display, window) = handles(&made).ok_or(NO_DISPLAY)?;
        // SAFETY: display and window are open, zero is a colour, and what is pointed to outlives the calls. Xlib's picture
        // without pixels belongs to nobody else.
        let mut window = unsafe {
            let screen = &*(*display).screen();
            let (visual, depth) = (screen.root_visual, screen.root_depth as c_uint);
            let format = xlib::ZPixmap;
            let image =
                (x.XCreateImage)(display, visual, depth, format, 0, null_mut(), 1, 1, 32, 0);
            if (*image).bits_per_pixel != 32 {
                return Err("X display without pixels of 32 bits");
            }
            let dot = (x.XCreateBitmapFromData)(display, window, c"".as_ptr(), 1, 1);
            let mut colour: xlib::XColor = zeroed();
            let colour = &raw mut colour;
            Window {
                x,
                display,
                window,
                root: screen.root,
                delete: 0,
                size: (width, height),
                no_pointer: (x.XCreatePixmapCursor)(display, dot, dot, colour, colour, 0, 0),
                before: None,
                context: screen.default_gc,
                image,
                put_image: PutImage::ThroughSocket,
                frames: [&mut [], &mut []],
                drawn: (0, 0),
                presses: Presses::default(),
                _made: made,
            }
        };
        window.find_memory();
        window.set_title(title);
        window.delete = window.atom(c"WM_DELETE_WINDOW");
        // SAFETY: the window exists, and what is pointed to outlives the call.
        unsafe {
            let events = xlib::StructureNotifyMask | xlib::KeyPressMask;
            (x.XSelectInput)(display, window.window, events);
            (x.XSetWMProtocols)(display, window.window, &mut window.delete, 1);
            // The name of the window and that of the program, by which desktops find its rules.
            let class = b"eightfold\0Eightfold\0";
            (x.XChangeProperty)(
                display,
                window.window,
                xlib::XA_WM_CLASS,
                xlib::XA_STRING,
                8,
                xlib::PropModeReplace,
                class.as_ptr(),
                class.len() as c_int,
            );
        }
        window.place(width, height);
        // SAFETY: the display is open.
        unsafe { (x.XSync)(display, xlib::False) };
        Ok(window)
    }

    pub(crate) fn atom(&self, name: &CStr) -> xlib::Atom {
        // SAFETY: the display is open, and the name outlives the call.
        unsafe { (self.x.XInternAtom)(self.display, name.as_ptr(), xlib::False) }
    }

    /// Names the window anew.
    pub fn set_title(&mut self, title: &CStr) {
        let Window {
            x, display, window, ..
        } = *self;
        // SAFETY: the window exists, and what is pointed to outlives the calls and is as long as it says.
        unsafe {
            (x.XStoreName)(display, window, title.as_ptr());
            (x.XChangeProperty)(
                display,
                window,
                self.atom(c"_NET_WM_NAME"),
                self.atom(c"UTF8_STRING"),
                8,
                xlib::PropModeReplace,
                title.as_ptr().cast(),
                title.count_bytes() as c_int,
            );
        }
    }
}

/// What the lab asks of its window.
impl Window {
    /// The keys pressed since the last call, in order; one that is held comes again and again. Of more than 32 the rest is
    /// lost.
    pub fn presses(&mut self) -> impl Iterator<Item = Press> + use<> {
        take(&mut self.presses).into_iter()
    }
}

impl Screen for Window {
    fn size(&self) -> (usize, usize) {
        self.size
    }

    fn canvas(&mut self, width: usize, height: usize) -> &mut [u32] {
        self.drawn = (width, height);
        &mut self.frames[0][..width * height]
    }

    fn show(&mut self) -> Next {
        self.blit();
        let mut fullscreen = None;
        // SAFETY: zero is a value of every field of an event, and which of its parts is there is told by its type.
        unsafe {
            let mut event: xlib::XEvent = zeroed();
            while (self.x.XPending)(self.display) > 0 {
                (self.x.XNextEvent)(self.display, &mut event);
                match event.type_ {
                    xlib::KeyPress => match pressed(self.x, &event.key) {
                        keysym::XK_Escape => return Next::End(0),
                        keysym::XK_f => fullscreen = Some(true),
                        keysym::XK_w => fullscreen = Some(false),
                        key => {
                            if let Some(press) = Press::of(key) {
                                self.presses.push(press);
                            }
                        }
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
        if CLOSED.load(Relaxed) {
            return Next::End(0);
        }
        if let Some(on) = fullscreen {
            self.set_fullscreen(on);
        }
        Next::GoOn
    }
}

/// Has `minifb` open the display and make a window that is not shown yet.
fn make(title: &CStr) -> Option<minifb::Window> {
    let options = WindowOptions {
        resize: true,
        scale: Scale::X1,
        ..WindowOptions::default()
    };
    // `minifb` keeps a picture of this size, which nobody draws to. The window gets its own when it is shown.
    minifb::Window::new(title.to_str().ok()?, 1, 1, options).ok()
}

/// What Xlib knows the display and the window by.
fn handles(made: &minifb::Window) -> Option<(*mut xlib::Display, xlib::Window)> {
    let RawDisplayHandle::Xlib(display) = made.display_handle().ok()?.as_raw() else {
        return None;
    };
    let RawWindowHandle::Xlib(window) = made.window_handle().ok()?.as_raw() else {
        return None;
    };
    Some((display.display?.as_ptr().cast(), window.window))
}

/// Takes note if somebody destroyed the window. Xlib's own function would end the process.
///
/// What else the server refuses, as a focus that can't be set yet, does no harm.
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
