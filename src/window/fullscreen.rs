//! The whole screen, and back.
//!
//! A window manager is asked to (EWMH): it keeps panels away and the window's place. Without one, the window is placed
//! over the screen.

use core::{
    ffi::{c_int, c_long, c_uint},
    mem::zeroed,
};

use x11_dl::xlib;

use crate::window::Window;

/// Position on the screen, and size.
#[derive(Clone, Copy)]
pub(crate) struct Place {
    x: c_int,
    y: c_int,
    width: c_int,
    height: c_int,
}

impl Window {
    /// Shows the window for the first time, with a size, in the middle of the screen if no window manager knows better.
    pub(crate) fn place(&self, width: usize, height: usize) {
        let (width, height) = (width as c_int, height as c_int);
        let (screen, _) = self.attributes(self.root);
        self.move_to(Place {
            x: c_int::max(screen.width - width, 0) / 2,
            y: c_int::max(screen.height - height, 0) / 2,
            width,
            height,
        });
    }

    /// Goes to the whole screen and hides the pointer, or back to the window where it was and as it was.
    pub fn set_fullscreen(&mut self, on: bool) {
        let pointer = if on { self.no_pointer } else { 0 };
        // SAFETY: the window exists, and the pointer, or 0 for the desktop's own.
        unsafe { (self.x.XDefineCursor)(self.display, self.window, pointer) };
        let (screen, listening) = self.attributes(self.root);
        if let Some(place) = self.before {
            if !on {
                self.before = None;
                self.move_to(place);
            }
        } else if listening & xlib::SubstructureRedirectMask != 0 {
            self.ask_manager(on);
        } else if on {
            self.before = Some(self.attributes(self.window).0);
            self.move_to(screen);
            // SAFETY: the window exists.
            unsafe {
                let (display, window) = (self.display, self.window);
                (self.x.XSetInputFocus)(display, window, xlib::RevertToPointerRoot, 0);
            }
        }
    }

    /// A window's place in its parent, and the events that anybody listens to on it. (A window manager listens on the
    /// root window; its properties may be left over.)
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
            width: attributes.width,
            height: attributes.height,
        };
        (place, attributes.all_event_masks)
    }

    /// Asks the window manager to add or to remove the fullscreen state.
    fn ask_manager(&self, fullscreen: bool) {
        // SAFETY: zero is a value of every field, and the event outlives the call.
        unsafe {
            let mut event: xlib::XEvent = zeroed();
            let message = &mut event.client_message;
            message.type_ = xlib::ClientMessage;
            message.window = self.window;
            message.message_type = self.atom(c"_NET_WM_STATE");
            message.format = 32;
            // Add or remove, this state, no second one; from an application.
            let [change, state, _, source, _] = &mut message.data.longs;
            *change = c_long::from(fullscreen);
            *state = self.atom(c"_NET_WM_STATE_FULLSCREEN") as c_long;
            *source = 1;
            (self.x.XSendEvent)(
                self.display,
                self.root,
                xlib::False,
                xlib::SubstructureNotifyMask | xlib::SubstructureRedirectMask,
                &mut event,
            );
        }
    }

    /// Puts the window somewhere, above the others.
    fn move_to(&self, place: Place) {
        let (width, height) = (place.width as c_uint, place.height as c_uint);
        let (display, window) = (self.display, self.window);
        // SAFETY: the window exists.
        unsafe {
            (self.x.XMoveResizeWindow)(display, window, place.x, place.y, width, height);
            (self.x.XMapRaised)(display, window);
        }
    }
}
