//! Fullscreen through the window manager (EWMH), which hides panels and remembers the window's
//! position. Without EWMH, the window covers its monitor and follows the monitor's changes.

use core::ffi::{c_int, c_long, c_uint};
use core::mem::zeroed;
use core::ptr::null_mut;
use core::slice::from_raw_parts;

use x11_dl::xlib;

use super::{Toplevel, functions::XINERAMA};

#[derive(Clone, Copy)]
pub struct Place {
    pub x: c_int,
    pub y: c_int,
    pub width: c_int,
    pub height: c_int,
}

impl Toplevel {
    pub fn set_fullscreen(&mut self, on: bool) {
        let pointer = if on { self.no_pointer } else { 0 };
        // SAFETY: the window exists, and so does the pointer; 0 is the desktop's own.
        unsafe { (self.x.XDefineCursor)(self.display, self.window, pointer) };
        if let Some(mut place) = self.before {
            if !on {
                self.before = None;
                // The screen may be smaller than before.
                let (screen, _) = self.attributes(self.root);
                if place.x >= screen.width || place.y >= screen.height {
                    (place.x, place.y) = (0, 0);
                }
                self.move_to(place);
            }
        } else if self.is_managed() && self.has_property(self.root, self.atom(c"_NET_SUPPORTED")) {
            self.ask_manager(on);
        } else if on {
            self.cover();
            let (display, window) = (self.display, self.window);
            // SAFETY: the window exists.
            unsafe { (self.x.XSetInputFocus)(display, window, xlib::RevertToPointerRoot, 0) };
        }
    }

    /// Covers a monitor whose place or mode has changed, unless a window manager does.
    pub fn follow_monitor(&mut self) {
        if self.before.is_some() {
            self.cover();
        }
    }

    fn cover(&mut self) {
        let (mut place, _) = self.attributes(self.window);
        let (mut x, mut y, mut child) = (0, 0, 0);
        let translate = self.x.XTranslateCoordinates;
        // SAFETY: the windows exist, and the results are writable.
        unsafe {
            translate(self.display, self.window, self.root, 0, 0, &mut x, &mut y, &mut child)
        };
        let is_over = self.before.is_some();
        // A smaller mode may not show the middle of the window.
        let half = if is_over { 0 } else { 1 };
        let mut over = self.monitor(x + place.width / 2 * half, y + place.height / 2 * half);
        let size = (place.width, place.height);
        if is_over && (x, y, size) == (over.x, over.y, (over.width, over.height)) {
            return;
        }
        if self.is_managed() {
            // The window manager moves its frame: put its left and upper parts beyond the monitor.
            let (left, top) = (place.x, place.y);
            (over.x, over.y) = (over.x - left, over.y - top);
            (place.x, place.y) = (x - left, y - top);
        }
        self.before.get_or_insert(place);
        self.move_to(over);
    }

    pub fn is_managed(&self) -> bool {
        let (_, listening) = self.attributes(self.root);
        listening & xlib::SubstructureRedirectMask != 0
    }

    /// Returns a monitor that shows a point, otherwise the first monitor, otherwise the screen.
    pub fn monitor(&self, x: c_int, y: c_int) -> Place {
        let (mut found, _) = self.attributes(self.root);
        let mut count = 0;
        let mut list = null_mut();
        if let Some(xinerama) = XINERAMA.open() {
            // SAFETY: the display is open. A query without the extension prints a message.
            unsafe {
                if (xinerama.XineramaIsActive)(self.display) != 0 {
                    list = (xinerama.XineramaQueryScreens)(self.display, &mut count);
                }
            }
        }
        if list.is_null() {
            return found;
        }
        // SAFETY: the list has this length.
        let monitors = unsafe { from_raw_parts(list, count as usize) };
        for (index, monitor) in monitors.iter().enumerate() {
            let place = Place {
                x: monitor.x_org.into(),
                y: monitor.y_org.into(),
                width: monitor.width.into(),
                height: monitor.height.into(),
            };
            let (dx, dy) = (x - place.x, y - place.y);
            if index == 0 || (0..place.width).contains(&dx) && (0..place.height).contains(&dy) {
                found = place;
            }
        }
        // SAFETY: it is not used again.
        unsafe { (self.x.XFree)(list.cast()) };
        found
    }

    fn has_property(&self, window: xlib::Window, property: xlib::Atom) -> bool {
        let mut count = 0;
        // SAFETY: the window exists. Xlib gives the list's length. The list is leaked, as calls are
        // rare.
        unsafe {
            let list = (self.x.XListProperties)(self.display, window, &mut count);
            !list.is_null() && from_raw_parts(list, count as usize).contains(&property)
        }
    }

    /// Returns a window's position in its parent, and the events that clients select on it. A
    /// window manager that has ended may leave properties, but selects no events.
    #[inline(never)]
    pub fn attributes(&self, window: xlib::Window) -> (Place, c_long) {
        // SAFETY: zero is valid for all fields, and the window exists.
        unsafe {
            let mut attributes: xlib::XWindowAttributes = zeroed();
            (self.x.XGetWindowAttributes)(self.display, window, &mut attributes);
            let place = Place {
                x: attributes.x,
                y: attributes.y,
                width: attributes.width,
                height: attributes.height,
            };
            (place, attributes.all_event_masks)
        }
    }

    fn ask_manager(&self, fullscreen: bool) {
        // SAFETY: zero is valid for all fields, and the event outlives the call.
        unsafe {
            let mut event: xlib::XEvent = zeroed();
            let message = &mut event.client_message;
            message.type_ = xlib::ClientMessage;
            message.window = self.window;
            message.message_type = self.atom(c"_NET_WM_STATE");
            message.format = 32;
            // Add or remove; this state; no second state; from an application.
            message.data.set_long(0, c_long::from(fullscreen));
            let state = self.atom(c"_NET_WM_STATE_FULLSCREEN") as c_long;
            message.data.set_long(1, state);
            message.data.set_long(3, 1);
            let events = xlib::SubstructureNotifyMask | xlib::SubstructureRedirectMask;
            (self.x.XSendEvent)(self.display, self.root, xlib::False, events, &mut event);
        }
    }

    #[inline(never)]
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
