//! Windows: the whole screen by a window without a border, of the monitor's size, and pixels of the monitor's.

use core::{
    ffi::c_uint,
    mem::{size_of, zeroed},
    ptr::null_mut,
};

use winapi::{shared::windef::HWND, um::winuser};

/// The style bits of a window with a frame, a title and its buttons.
const FRAME: isize = winuser::WS_OVERLAPPEDWINDOW as isize;

/// A display that `minifb` opens a window on.
pub struct Display {
    /// Why there is no window if it can't.
    pub why_not: &'static str,
}

impl Display {
    /// The only one. The window gets pixels of the monitor's, not larger ones that the system would stretch on a fine monitor.
    pub fn choose() -> Result<Display, &'static str> {
        // SAFETY: it may be called at any time before there is a window.
        unsafe { winuser::SetProcessDPIAware() };
        Ok(Display {
            why_not: "no display",
        })
    }

    /// Has `minifb` open a window on it.
    pub fn open<T>(&self, window: impl FnOnce() -> T) -> T {
        window()
    }
}

/// The functions for a window that `minifb` lacks.
pub struct Desktop {
    window: HWND,
    /// The window's place before it covered the screen.
    before: Option<winuser::WINDOWPLACEMENT>,
}

impl Desktop {
    pub fn of(_: Display, window: &minifb::Window) -> Desktop {
        Desktop {
            window: window.get_window_handle().cast(),
            before: None,
        }
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
        0.1 * f32::from(winuser::WHEEL_DELTA)
    }

    /// The exit code if the window is lost.
    pub fn end(&self) -> Option<i32> {
        // SAFETY: it may be asked of any handle.
        (unsafe { winuser::IsWindow(self.window) } == 0).then_some(0)
    }

    /// Covers the monitor that the window is on, without a frame and a pointer, or goes back to where it was.
    pub fn set_fullscreen(&mut self, shown: &mut minifb::Window, on: bool) {
        if on == self.before.is_some() {
            return;
        }
        shown.set_cursor_visibility(!on);
        let window = self.window;
        // SAFETY: the window exists; zero is a value of every field of what is pointed to, which outlives the calls.
        unsafe {
            let style = winuser::GetWindowLongPtrW(window, winuser::GWL_STYLE);
            if let Some(place) = self.before.take() {
                winuser::SetWindowLongPtrW(window, winuser::GWL_STYLE, style | FRAME);
                winuser::SetWindowPlacement(window, &place);
                let same = winuser::SWP_NOMOVE | winuser::SWP_NOSIZE | winuser::SWP_NOZORDER;
                move_to(window, [0; 4], same);
                return;
            }
            let mut place: winuser::WINDOWPLACEMENT = zeroed();
            place.length = size_of::<winuser::WINDOWPLACEMENT>() as u32;
            winuser::GetWindowPlacement(window, &mut place);
            let mut monitor: winuser::MONITORINFO = zeroed();
            monitor.cbSize = size_of::<winuser::MONITORINFO>() as u32;
            let nearest = winuser::MonitorFromWindow(window, winuser::MONITOR_DEFAULTTONEAREST);
            if winuser::GetMonitorInfoW(nearest, &mut monitor) == 0 {
                return;
            }
            self.before = Some(place);
            winuser::SetWindowLongPtrW(window, winuser::GWL_STYLE, style & !FRAME);
            let all = monitor.rcMonitor;
            let size = [all.right - all.left, all.bottom - all.top];
            move_to(window, [all.left, all.top, size[0], size[1]], 0);
        }
    }
}

/// Moves a window above the others, and lets it have the frame that its style says.
///
/// # Safety
/// The window has to exist.
unsafe fn move_to(window: HWND, [x, y, width, height]: [i32; 4], flags: c_uint) {
    let flags = flags | winuser::SWP_FRAMECHANGED | winuser::SWP_NOOWNERZORDER;
    // SAFETY: the caller vouches for the window.
    unsafe { winuser::SetWindowPos(window, null_mut(), x, y, width, height, flags) };
}
