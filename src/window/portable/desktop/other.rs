//! Nothing but what `minifb` can do.

use core::ffi::c_uint;

/// A display that `minifb` opens a window on.
pub struct Display {
    /// Why there is no window if it can't.
    pub why_not: &'static str,
}

impl Display {
    /// The only one.
    pub fn choose() -> Result<Display, &'static str> {
        Ok(Display {
            why_not: "no display",
        })
    }

    /// Has `minifb` open a window on it.
    pub fn open<T>(&self, window: impl FnOnce() -> T) -> T {
        window()
    }
}

/// The functions for a window that `minifb` lacks: none.
pub struct Desktop;

impl Desktop {
    pub fn of(_: Display, _: &minifb::Window) -> Desktop {
        Desktop
    }

    /// Whether `minifb` tells the keys.
    pub fn has_typing(&self) -> bool {
        true
    }

    /// Frames have the display's colours.
    pub fn colour(&self, _: &mut [u32]) {}

    /// The keys that were pressed, where [`Desktop::has_typing`] does not hold.
    pub fn keys(&mut self) -> Vec<c_uint> {
        Vec::new()
    }

    /// The number that `minifb` gives for a notch of the wheel away from the hand.
    pub fn notch(&self) -> f32 {
        1.0
    }

    /// The exit code if the window is lost.
    pub fn end(&self) -> Option<i32> {
        None
    }

    /// The desktop's own button or key does it, and not F.
    pub fn set_fullscreen(&mut self, _: &mut minifb::Window, _: bool) {}
}
