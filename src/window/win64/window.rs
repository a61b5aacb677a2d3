use core::ffi::{CStr, c_char, c_void};
use core::mem::{size_of, transmute, zeroed};
use core::ptr::null_mut;
use core::sync::atomic::{AtomicPtr, AtomicU32, Ordering::*};

use windows_sys::Win32::Foundation::{HANDLE, RECT};
use windows_sys::Win32::Graphics::Gdi::{
    BITMAPINFO, BITMAPINFOHEADER, MONITOR_DEFAULTTONEAREST, MONITORINFO, SRCCOPY,
};
use windows_sys::Win32::System::Power::{ES_CONTINUOUS, ES_DISPLAY_REQUIRED, ES_SYSTEM_REQUIRED};
use windows_sys::Win32::UI::HiDpi::DPI_AWARENESS_CONTEXT_PER_MONITOR_AWARE_V2;
use windows_sys::Win32::UI::Input::KeyboardAndMouse::{VK_CONTROL, VK_ESCAPE};
use windows_sys::Win32::UI::WindowsAndMessaging::{
    CS_OWNDC, CW_USEDEFAULT, GCLP_HCURSOR, GWL_STYLE, IDC_ARROW, PM_REMOVE, SWP_FRAMECHANGED,
    SWP_NOMOVE, SWP_NOSIZE, SWP_NOZORDER, SWP_SHOWWINDOW, WINDOWPLACEMENT, WM_KEYDOWN, WNDCLASSA,
    WNDPROC, WS_OVERLAPPEDWINDOW,
};

use super::functions::*;
use super::memory::pixels;
use super::threads::{spawn, wait, wake};
use crate::render_target::{InnerSize, Next, RenderTarget, fit};

const CLASS: &CStr = c"Eightfold";

/// Frames between two looks at the monitor in fullscreen: a quarter of a second.
const LOOK: u8 = 16;

const FRAME: isize = WS_OVERLAPPEDWINDOW as isize;

/// The key repeats.
const REPEATED: isize = 1 << 30;

const ESCAPE: u8 = VK_ESCAPE as u8;

/// Keeps system and display on, as long as the thread lives.
const SCREEN_ON: u32 = ES_CONTINUOUS | ES_SYSTEM_REQUIRED | ES_DISPLAY_REQUIRED;

pub const KEYS: &str = "F fullscreen, W window, H hud, Esc or Q quit";

/// A window, whose thread handles messages, size and keys, so that it responds while a frame is
/// drawn. A closed window has no size.
pub struct Window {
    window: HANDLE,
    context: HANDLE,
    size: (usize, usize),
    pixels: &'static mut [u32],
    frame_size: (usize, usize),
    frame_number: u8,
}

struct Opening {
    title: *const c_char,
    size: (i32, i32),
    shrinks: bool,
    pointers: [HANDLE; 2],
    thread: u32,
    /// The window, or null if opening failed, once `is_done` is 1.
    window: AtomicPtr<c_void>,
    is_done: AtomicU32,
}

extern "C" fn window_main(opening: *mut c_void) -> *mut c_void {
    // SAFETY: `Window::open` passes it, and never frees it.
    let opening = unsafe { &*opening.cast::<Opening>() };
    let (width, height) = opening.size;
    let none = null_mut();
    let (class, title) = (CLASS.as_ptr().cast(), opening.title.cast());
    let style = FRAME as u32;
    // SAFETY: pointers outlive the calls; zero is valid for all fields of a message.
    unsafe {
        SetThreadExecutionState(SCREEN_ON);
        let x = CW_USEDEFAULT;
        let window =
            CreateWindowExA(0, class, title, style, x, 0, width, height, none, none, none, none);
        // Add the frame's size, which is the difference from the inner size, and show the window.
        let inside = inside(window).unwrap_or_default();
        let frame = [width - inside.right, height - inside.bottom];
        let (mut x, mut y, mut size, mut flags) = (0, 0, opening.size, SWP_SHOWWINDOW | SWP_NOMOVE);
        if let (true, Some(monitor)) = (opening.shrinks, monitor(window)) {
            let room = monitor.rcWork;
            let sides = [room.right - room.left - frame[0], room.bottom - room.top - frame[1]];
            let [width, height] = [width, height].map(|side| side as usize);
            let fitting = fit((width, height), sides.map(|side| side.max(1) as usize).into());
            size = (fitting.0 as i32, fitting.1 as i32);
            if size != opening.size {
                (x, y, flags) = (room.left, room.top, SWP_SHOWWINDOW);
            }
        }
        let (width, height) = (size.0 + frame[0], size.1 + frame[1]);
        SetWindowPos(window, none, x, y, width, height, flags);
        opening.window.store(window, Relaxed);
        opening.is_done.store(1, Release);
        wake(&opening.is_done);
        let mut cover = Cover { window, before: None, pointers: opening.pointers };
        let mut message = zeroed();
        while GetMessageA(&mut message, none, 0, 0) > 0 {
            // Ignore keys with Ctrl. (Alt sends other messages.)
            let is_new = message.message == WM_KEYDOWN && message.lParam & REPEATED == 0;
            if is_new && GetKeyState(VK_CONTROL.into()) >= 0 {
                match message.wParam as u8 {
                    b'F' => cover.set(true),
                    b'W' => cover.set(false),
                    key => _ = PostThreadMessageA(opening.thread, WM_KEYDOWN, key.into(), 0),
                }
            }
            DispatchMessageA(&message);
        }
    }
    none
}

/// The fullscreen state. Only the window's thread may change it: after another thread's change,
/// Wine may keep the old size.
struct Cover {
    window: HANDLE,
    before: Option<WINDOWPLACEMENT>,
    pointers: [HANDLE; 2],
}

impl Cover {
    fn set(&mut self, on: bool) {
        let none = null_mut();
        // SAFETY: the functions ignore a closed window. Pointers outlive the calls.
        unsafe {
            let style = GetWindowLongPtrA(self.window, GWL_STYLE);
            if on {
                let Some(monitor) = monitor(self.window) else {
                    return;
                };
                if self.before.is_none() {
                    let mut place = WINDOWPLACEMENT {
                        length: size_of::<WINDOWPLACEMENT>() as u32,
                        ..WINDOWPLACEMENT::default()
                    };
                    GetWindowPlacement(self.window, &mut place);
                    self.before = Some(place);
                    SetWindowLongPtrA(self.window, GWL_STYLE, style & !FRAME);
                }
                // Wine may have kept the old size.
                let all = monitor.rcMonitor;
                let (width, height) = (all.right - all.left, all.bottom - all.top);
                let (left, top) = (all.left, all.top);
                SetWindowPos(self.window, none, left, top, width, height, SWP_FRAMECHANGED);
            } else if let Some(place) = self.before.take() {
                SetWindowLongPtrA(self.window, GWL_STYLE, style | FRAME);
                SetWindowPlacement(self.window, &place);
                let flags = SWP_NOMOVE | SWP_NOSIZE | SWP_NOZORDER | SWP_FRAMECHANGED;
                SetWindowPos(self.window, none, 0, 0, 0, 0, flags);
            }
            SetClassLongPtrA(self.window, GCLP_HCURSOR, self.pointers[usize::from(on)]);
        }
    }
}

fn monitor(window: HANDLE) -> Option<MONITORINFO> {
    let mut monitor =
        MONITORINFO { cbSize: size_of::<MONITORINFO>() as u32, ..MONITORINFO::default() };
    // SAFETY: any handles are allowed, and `monitor` is writable.
    let is_known = unsafe {
        let nearest = MonitorFromWindow(window, MONITOR_DEFAULTTONEAREST);
        GetMonitorInfoA(nearest, &mut monitor) != 0
    };
    is_known.then_some(monitor)
}

fn inside(window: HANDLE) -> Option<RECT> {
    let mut inside = RECT::default();
    // SAFETY: any handle is allowed, and `inside` is writable.
    let is_there = unsafe { GetClientRect(window, &mut inside) } != 0;
    is_there.then_some(inside)
}

impl Window {
    pub fn open(title: &CStr, size: InnerSize) -> Result<Window, &'static str> {
        let (size, shrinks) = size.parts();
        const NONE: &str = "desktop is missing";
        // SAFETY: zero is valid for all other fields, and pointers outlive the calls.
        let (pointers, thread) = unsafe {
            SetProcessDpiAwarenessContext(DPI_AWARENESS_CONTEXT_PER_MONITOR_AWARE_V2);
            let arrow = LoadCursorA(null_mut(), IDC_ARROW);
            let class = WNDCLASSA {
                style: CS_OWNDC,
                lpfnWndProc: transmute::<*const c_void, WNDPROC>(default_procedure()),
                hCursor: arrow,
                lpszClassName: CLASS.as_ptr().cast(),
                ..WNDCLASSA::default()
            };
            RegisterClassA(&class);
            // A transparent cursor of the standard size.
            let (keep, invert) = ([0xff_u8; 4 * 32], [0_u8; 4 * 32]);
            let (keep, invert) = (keep.as_ptr(), invert.as_ptr());
            let nothing = CreateCursor(null_mut(), 0, 0, 32, 32, keep, invert);
            ([arrow, nothing], GetCurrentThreadId())
        };
        let opening = Box::leak(Box::new(Opening {
            title: title.as_ptr(),
            size: (size.0 as i32, size.1 as i32),
            shrinks,
            pointers,
            thread,
            window: AtomicPtr::new(null_mut()),
            is_done: AtomicU32::new(0),
        }));
        // SAFETY: it is never freed, and only its atomic fields change; the title outlives the
        // wait.
        unsafe { spawn(window_main, (&raw mut *opening).cast()) }.ok_or(NONE)?;
        while opening.is_done.load(Acquire) == 0 {
            wait(&opening.is_done, 0);
        }
        let window = opening.window.load(Relaxed);
        if window.is_null() {
            return Err(NONE);
        }
        let mut window = Window {
            window,
            // SAFETY: any handle is allowed.
            context: unsafe { GetDC(window) },
            size: (0, 0),
            pixels: pixels(),
            frame_size: (0, 0),
            frame_number: 0,
        };
        window.update_size();
        Ok(window)
    }

    pub fn set_fullscreen(&mut self, on: bool) {
        let key = if on { b'F' } else { b'W' };
        // SAFETY: it may be posted to any window.
        unsafe { PostMessageA(self.window, WM_KEYDOWN, key.into(), 0) };
    }

    fn is_misplaced(&self) -> bool {
        // SAFETY: any handle is allowed.
        let style = unsafe { GetWindowLongPtrA(self.window, GWL_STYLE) };
        let (width, height) = (self.size.0 as i32, self.size.1 as i32);
        style & FRAME == 0
            // Not minimised.
            && width > 0
            && monitor(self.window).is_some_and(|monitor| {
                let all = monitor.rcMonitor;
                (all.right - all.left, all.bottom - all.top) != (width, height)
            })
    }

    fn update_size(&mut self) -> bool {
        let inside = inside(self.window);
        let size = inside.unwrap_or_default();
        self.size = (size.right as usize, size.bottom as usize);
        inside.is_some()
    }
}

impl RenderTarget for Window {
    fn size(&self) -> (usize, usize) {
        self.size
    }

    fn canvas(&mut self, width: usize, height: usize) -> &mut [u32] {
        self.frame_size = (width, height);
        &mut self.pixels[..width * height]
    }

    fn show(&mut self) -> Next {
        let (width, height) = (self.frame_size.0 as i32, self.frame_size.1 as i32);
        let info = BITMAPINFO {
            bmiHeader: BITMAPINFOHEADER {
                biSize: size_of::<BITMAPINFOHEADER>() as u32,
                biWidth: width,
                // The first row is the top.
                biHeight: -height,
                biPlanes: 1,
                biBitCount: 32,
                ..BITMAPINFOHEADER::default()
            },
            ..BITMAPINFO::default()
        };
        let (columns, rows) = (self.size.0 as i32, self.size.1 as i32);
        // SAFETY: the pixels have this size, and outlive the call.
        unsafe {
            let (context, pixels) = (self.context, self.pixels.as_ptr());
            StretchDIBits(
                context, 0, 0, columns, rows, 0, 0, width, height, pixels, &info, 0, SRCCOPY,
            );
        }
        let mut next = Next::GoOn;
        // SAFETY: zero is valid for all fields of a message, which outlives the call.
        unsafe {
            let mut message = zeroed();
            while PeekMessageA(&mut message, null_mut(), 0, 0, PM_REMOVE) != 0 {
                match message.wParam as u8 {
                    _ if message.message != WM_KEYDOWN => {}
                    ESCAPE | b'Q' => return Next::End(0),
                    b'H' => next = next.toggled(),
                    _ => {}
                }
            }
        }
        if !self.update_size() {
            return Next::End(0);
        }
        self.frame_number = self.frame_number.wrapping_add(1);
        if self.frame_number.is_multiple_of(LOOK) && self.is_misplaced() {
            self.set_fullscreen(true);
        }
        next
    }
}
