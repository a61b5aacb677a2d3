//! Wayland: what `minifb` does not do with a window there.

use core::ffi::{c_int, c_void};

use raw_window_handle::{HasDisplayHandle, HasWindowHandle, RawDisplayHandle, RawWindowHandle};

use crate::loading::{Table, loaded};

loaded! {
    /// Functions of a connection.
    Client, CLIENT_NAMES:
    fn wl_display_flush(*mut c_void) -> c_int;
    fn wl_display_get_error(*mut c_void) -> c_int;
    fn wl_display_get_fd(*mut c_void) -> c_int;
    fn wl_proxy_get_id(*mut c_void) -> u32;
}

static CLIENT: Table<Client> = Table::new();

/// By how much the number of a window's `xdg_toplevel` is larger than that of its surface, which alone `minifb` tells. Numbers are
/// given in order, and `minifb` 0.29.0 makes these in between: the memory of the first frame, its buffer, the `xdg_wm_base` and the
/// `xdg_surface`.
const TOPLEVEL_AFTER_SURFACE: u32 = 5;

/// The requests of an `xdg_toplevel`, by their numbers in the protocol.
const SET_FULLSCREEN: u32 = 11;
const UNSET_FULLSCREEN: u32 = 12;

/// A window of `minifb`'s on Wayland, as long as that is there.
pub struct Window {
    client: &'static Client,
    display: *mut c_void,
    surface: *mut c_void,
}

impl Window {
    /// That of a window, if it is one on Wayland.
    pub fn of(window: &minifb::Window) -> Option<Window> {
        let RawDisplayHandle::Wayland(display) = window.display_handle().ok()?.as_raw() else {
            return None;
        };
        let RawWindowHandle::Wayland(surface) = window.window_handle().ok()?.as_raw() else {
            return None;
        };
        Some(Window {
            client: CLIENT.open(c"libwayland-client.so.0", CLIENT_NAMES)?,
            display: display.display.as_ptr(),
            surface: surface.surface.as_ptr(),
        })
    }

    /// Whether the connection is broken.
    pub fn is_lost(&self) -> bool {
        // SAFETY: the display is open, and there is one file to look at.
        unsafe {
            let mut file = libc::pollfd {
                fd: (self.client.wl_display_get_fd)(self.display),
                events: 0,
                revents: 0,
            };
            libc::poll(&mut file, 1, 0);
            file.revents != 0 || (self.client.wl_display_get_error)(self.display) != 0
        }
    }

    /// Asks the compositor for the whole screen, or for the window. Does nothing while it takes no requests.
    pub fn set_fullscreen(&self, on: bool) {
        // SAFETY: display and surface are there, and the message is as long as it says.
        unsafe {
            let toplevel = (self.client.wl_proxy_get_id)(self.surface) + TOPLEVEL_AFTER_SURFACE;
            // The object; the length in bytes above the request; and no screen preferred, where one may be.
            let message = if on {
                &[toplevel, 12 << 16 | SET_FULLSCREEN, 0][..]
            } else {
                &[toplevel, 8 << 16 | UNSET_FULLSCREEN][..]
            };
            // No other message is under way then, so that this one does not come between its parts.
            if (self.client.wl_display_flush)(self.display) >= 0 {
                let file = (self.client.wl_display_get_fd)(self.display);
                let flags = libc::MSG_DONTWAIT | libc::MSG_NOSIGNAL;
                libc::send(file, message.as_ptr().cast(), size_of_val(message), flags);
            }
        }
    }
}
