//! The whole screen, and back.
//!
//! With a window manager that knows how (EWMH), it is asked to: it keeps panels away and the window's
//! place. Without, the window is placed over the screen, past the window manager if there is one.

use core::{
    ffi::{CStr, c_int, c_long, c_uint, c_ulong},
    mem::zeroed,
    ptr::null_mut,
};

use x11_dl::xlib::{self, Functions};

/// A window's way to the whole screen and back.
pub(crate) struct Fullscreen {
    x: Functions,
    display: *mut xlib::Display,
    window: xlib::Window,
    root: xlib::Window,
    /// A pointer without a picture.
    no_pointer: xlib::Cursor,
    /// Where the window was before it was placed over the screen without a window manager's help.
    before: Option<Place>,
}

/// Position on the screen, and size.
#[derive(Clone, Copy, PartialEq)]
struct Place {
    x: c_int,
    y: c_int,
    width: c_uint,
    height: c_uint,
}

impl Fullscreen {
    /// For a window on a display.
    pub fn new(x: Functions, display: *mut xlib::Display, window: xlib::Window) -> Fullscreen {
        // SAFETY: display and window are open, zero is a colour, and what is pointed to outlives the
        // calls.
        unsafe {
            let dot = (x.XCreateBitmapFromData)(display, window, c"".as_ptr(), 1, 1);
            let mut colour: xlib::XColor = zeroed();
            let colour = &raw mut colour;
            Fullscreen {
                x,
                display,
                window,
                root: (x.XDefaultRootWindow)(display),
                no_pointer: (x.XCreatePixmapCursor)(display, dot, dot, colour, colour, 0, 0),
                before: None,
            }
        }
    }

    /// Shows the window for the first time, with a size, in the middle of the screen if no window manager knows better.
    pub fn show(&self, width: usize, height: usize) {
        let (screen, _) = self.attributes(self.root);
        let (width, height) = (width as c_uint, height as c_uint);
        let before = |all: c_uint, part: c_uint| (all.saturating_sub(part) / 2) as c_int;
        self.move_to(Place {
            x: before(screen.width, width),
            y: before(screen.height, height),
            width,
            height,
        });
        // SAFETY: the window exists.
        unsafe {
            (self.x.XMapRaised)(self.display, self.window);
            (self.x.XFlush)(self.display);
        }
    }

    /// Goes to the whole screen and hides the pointer.
    pub fn enter(&mut self) {
        self.set_pointer(self.no_pointer);
        if self.manager_can() {
            self.ask_manager(true);
        } else if self.before.is_none() {
            self.before = Some(self.place());
            self.put(self.attributes(self.root).0, true);
        }
    }

    /// Keeps the window over the whole screen where no window manager does. One that has just let go of
    /// it puts it where it thinks best, and the screen's size can change.
    pub fn keep(&self) {
        if self.before.is_some() {
            let screen = self.attributes(self.root).0;
            if self.place() != screen {
                self.move_to(screen);
            }
        }
    }

    /// Goes back to the window where it was and as it was, and shows the pointer.
    pub fn leave(&mut self) {
        self.set_pointer(0);
        if let Some(place) = self.before.take() {
            self.put(place, false);
        } else {
            self.ask_manager(false);
        }
    }

    fn set_pointer(&self, pointer: xlib::Cursor) {
        // SAFETY: the window exists, and the pointer, or 0 for the desktop's own.
        unsafe { (self.x.XDefineCursor)(self.display, self.window, pointer) };
    }

    fn atom(&self, name: &CStr) -> xlib::Atom {
        // SAFETY: the display is open, and the name outlives the call.
        unsafe { (self.x.XInternAtom)(self.display, name.as_ptr(), xlib::False) }
    }

    /// The window's place on the screen.
    fn place(&self) -> Place {
        let (mut place, _) = self.attributes(self.window);
        // SAFETY: the windows exist, and what is pointed to outlives the call.
        unsafe {
            let (x, y) = (&mut place.x, &mut place.y);
            (self.x.XTranslateCoordinates)(
                self.display,
                self.window,
                self.root,
                0,
                0,
                x,
                y,
                &mut 0,
            );
        }
        place
    }

    /// A window's place in its parent, and the events that anybody listens to on it.
    fn attributes(&self, window: xlib::Window) -> (Place, c_long) {
        // SAFETY: zero is a value of every field, and the window exists.
        let attributes = unsafe {
            let mut attributes: xlib::XWindowAttributes = zeroed();
            (self.x.XGetWindowAttributes)(self.display, window, &mut attributes);
            attributes
        };
        let place = Place {
            x: attributes.x,
            y: attributes.y,
            width: attributes.width as c_uint,
            height: attributes.height as c_uint,
        };
        (place, attributes.all_event_masks)
    }

    /// Whether a window manager is there that has the fullscreen state.
    fn manager_can(&self) -> bool {
        const ATOM: xlib::Atom = 4;
        const MOST: c_long = 1024;
        let wanted = self.atom(c"_NET_WM_STATE_FULLSCREEN");
        let mut supported = null_mut();
        let (mut kind, mut format, mut count, mut left) = (0, 0, 0, 0);
        // SAFETY: what is pointed to outlives the call. A property of format 32 comes as longs, as
        // many as `count` says.
        let can = unsafe {
            (self.x.XGetWindowProperty)(
                self.display,
                self.root,
                self.atom(c"_NET_SUPPORTED"),
                0,
                MOST,
                xlib::False,
                ATOM,
                &mut kind,
                &mut format,
                &mut count,
                &mut left,
                &mut supported,
            );
            let can = !supported.is_null()
                && format == 32
                && core::slice::from_raw_parts(supported.cast::<c_ulong>(), count as usize)
                    .contains(&wanted);
            if !supported.is_null() {
                (self.x.XFree)(supported.cast());
            }
            can
        };
        can && self.managed()
    }

    /// Whether a window manager listens on the root window. Its properties may be left over.
    fn managed(&self) -> bool {
        self.attributes(self.root).1 & xlib::SubstructureRedirectMask != 0
    }

    /// Asks the window manager to add or to remove the fullscreen state.
    fn ask_manager(&self, fullscreen: bool) {
        // SAFETY: zero is a value of every field, and the event outlives the calls.
        unsafe {
            let mut event: xlib::XEvent = zeroed();
            event.client_message = xlib::XClientMessageEvent {
                type_: xlib::ClientMessage,
                window: self.window,
                message_type: self.atom(c"_NET_WM_STATE"),
                format: 32,
                data: xlib::ClientMessageData {
                    // Add or remove, this state, no second one; from an application.
                    longs: [
                        c_long::from(fullscreen),
                        self.atom(c"_NET_WM_STATE_FULLSCREEN") as c_long,
                        0,
                        1,
                        0,
                    ],
                },
                ..event.client_message
            };
            (self.x.XSendEvent)(
                self.display,
                self.root,
                xlib::False,
                xlib::SubstructureNotifyMask | xlib::SubstructureRedirectMask,
                &mut event,
            );
            (self.x.XFlush)(self.display);
        }
    }

    fn move_to(&self, place: Place) {
        let Place {
            x,
            y,
            width,
            height,
        } = place;
        // SAFETY: the window exists.
        unsafe { (self.x.XMoveResizeWindow)(self.display, self.window, x, y, width, height) };
    }

    /// Puts the window somewhere without the window manager: over everything, or back into its hands.
    fn put(&self, place: Place, above: bool) {
        // SAFETY: the window exists, zero is a value of every field, and what is pointed to outlives
        // the calls.
        unsafe {
            if self.managed() {
                // A window manager leaves alone what is mapped with this attribute.
                (self.x.XUnmapWindow)(self.display, self.window);
                let mut attributes: xlib::XSetWindowAttributes = zeroed();
                attributes.override_redirect = c_int::from(above);
                (self.x.XChangeWindowAttributes)(
                    self.display,
                    self.window,
                    xlib::CWOverrideRedirect,
                    &mut attributes,
                );
                let mut hints: xlib::XSizeHints = zeroed();
                hints.flags = xlib::USPosition | xlib::USSize | xlib::PWinGravity;
                (hints.x, hints.y) = (place.x, place.y);
                (hints.width, hints.height) = (place.width as c_int, place.height as c_int);
                hints.win_gravity = xlib::StaticGravity;
                (self.x.XSetWMNormalHints)(self.display, self.window, &mut hints);
            }
            self.move_to(place);
            (self.x.XMapRaised)(self.display, self.window);
            if above {
                (self.x.XSetInputFocus)(self.display, self.window, xlib::RevertToPointerRoot, 0);
            }
            (self.x.XFlush)(self.display);
        }
    }
}
