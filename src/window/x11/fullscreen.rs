//! The whole screen, and back.
//!
//! A window manager is asked to (EWMH): it keeps panels away and the window's place. Without one, the window is placed
//! over the screen.

use core::{
    ffi::{c_int, c_long, c_uint},
    mem::zeroed,
};

use super::{Toplevel, types as xlib};

/// Position on the screen, and size.
#[derive(Clone, Copy)]
pub struct Place {
    pub x: c_int,
    pub y: c_int,
    pub width: c_int,
    pub height: c_int,
}

impl Toplevel {
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
    pub fn attributes(&self, window: xlib::Window) -> (Place, c_long) {
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
    pub fn move_to(&self, place: Place) {
        let (width, height) = (place.width as c_uint, place.height as c_uint);
        let (display, window) = (self.display, self.window);
        // SAFETY: the window exists.
        unsafe {
            (self.x.XMoveResizeWindow)(display, window, place.x, place.y, width, height);
            (self.x.XMapRaised)(display, window);
        }
    }
}
