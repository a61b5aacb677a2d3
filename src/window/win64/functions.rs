//! The functions of Windows, looked up by name at the start.

#![allow(non_snake_case, reason = "the names that Windows has for them")]

use core::{cell::UnsafeCell, ffi::c_void, mem::MaybeUninit};

use windows_sys::Win32::Foundation::{HANDLE, RECT};
use windows_sys::Win32::Graphics::Gdi::{BITMAPINFO, MONITORINFO};
use windows_sys::Win32::Media::Audio::{WAVEFORMATEX, WAVEHDR};
use windows_sys::Win32::Media::MMTIME;
use windows_sys::Win32::UI::WindowsAndMessaging::{MSG, WINDOWPLACEMENT, WNDCLASSA};

pub type LoadLibrary = unsafe extern "win64" fn(*const u8) -> HANDLE;

pub type GetProcAddress = unsafe extern "win64" fn(HANDLE, *const u8) -> *const c_void;

/// Defines functions by library: a wrapper for each, a table of pointers, and the names. Names with
/// a dot are libraries.
macro_rules! functions {
    ($($library:literal: $( $(#[$attribute:meta])* fn $name:ident($($argument:ident: $type:ty),* $(,)?) $(-> $result:ty)?; )*)*) => {
        #[repr(C)]
        struct Table {
            $($( $name: unsafe extern "win64" fn($($type),*) $(-> $result)?, )*)*
        }

        const NAMES: &str = concat!($( $library, "\0", $( stringify!($name), "\0", )* )*);

        $($(
            $(#[$attribute])*
            /// # Safety
            /// See the documentation of Windows.
            #[inline(always)]
            #[allow(clippy::too_many_arguments, reason = "as Windows has them")]
            pub unsafe fn $name($($argument: $type),*) $(-> $result)? {
                // SAFETY: `load` has filled the table before anything else runs; the rest is
                // required of the caller.
                unsafe { (table().$name)($($argument),*) }
            }
        )*)*
    };
}

functions! {
    "kernel32.dll":
    fn AttachConsole(process: u32) -> i32;
    fn CreateFileA(name: *const u8, access: u32, share: u32, security: HANDLE, how: u32, flags: u32, template: HANDLE) -> HANDLE;
    fn CreateThread(security: HANDLE, stack: usize, start: *const c_void, pointer: *mut c_void, flags: u32, id: *mut u32) -> HANDLE;
    fn ExitProcess(code: u32) -> !;
    fn GetCommandLineW() -> *const u16;
    fn GetConsoleMode(file: HANDLE, mode: *mut u32) -> i32;
    fn GetCurrentThreadId() -> u32;
    fn GetLastError() -> u32;
    fn GetProcessAffinityMask(process: HANDLE, own: *mut usize, all: *mut usize) -> i32;
    fn GetStdHandle(stream: i32) -> HANDLE;
    fn MultiByteToWideChar(code: u32, flags: u32, from: *const u8, length: i32, to: *mut u16, room: i32) -> i32;
    fn QueryPerformanceCounter(count: *mut u64) -> i32;
    fn QueryPerformanceFrequency(rate: *mut u64) -> i32;
    fn SetStdHandle(stream: i32, file: HANDLE) -> i32;
    fn SetThreadExecutionState(flags: u32) -> u32;
    fn Sleep(milliseconds: u32);
    fn WaitForSingleObject(thing: HANDLE, milliseconds: u32) -> u32;
    fn WriteConsoleW(file: HANDLE, text: *const u16, length: u32, written: *mut u32, unused: HANDLE) -> i32;
    fn WriteFile(file: HANDLE, bytes: *const u8, length: u32, written: *mut u32, unused: HANDLE) -> i32;
    "api-ms-win-core-synch-l1-2-0.dll":
    fn WaitOnAddress(word: *const u32, value: *const u32, size: usize, milliseconds: u32) -> i32;
    fn WakeByAddressAll(word: *const u32);
    "shell32.dll":
    fn CommandLineToArgvW(line: *const u16, count: *mut i32) -> *const *mut u16;
    "user32.dll":
    fn CreateCursor(program: HANDLE, x: i32, y: i32, width: i32, height: i32, keep: *const u8, invert: *const u8) -> HANDLE;
    fn CreateWindowExA(extended: u32, class: *const u8, title: *const u8, style: u32, x: i32, y: i32, width: i32, height: i32, parent: HANDLE, menu: HANDLE, program: HANDLE, pointer: HANDLE) -> HANDLE;
    #[expect(dead_code, reason = "Windows alone calls it, see `default_procedure`")]
    fn DefWindowProcA() -> isize;
    fn DispatchMessageA(message: *const MSG) -> isize;
    fn GetClientRect(window: HANDLE, rectangle: *mut RECT) -> i32;
    fn GetDC(window: HANDLE) -> HANDLE;
    fn GetKeyState(key: i32) -> i16;
    fn GetMessageA(message: *mut MSG, window: HANDLE, first: u32, last: u32) -> i32;
    fn GetMonitorInfoA(monitor: HANDLE, info: *mut MONITORINFO) -> i32;
    fn GetWindowLongPtrA(window: HANDLE, what: i32) -> isize;
    fn GetWindowPlacement(window: HANDLE, place: *mut WINDOWPLACEMENT) -> i32;
    fn LoadCursorA(program: HANDLE, name: *const u16) -> HANDLE;
    fn MonitorFromWindow(window: HANDLE, otherwise: u32) -> HANDLE;
    fn PeekMessageA(message: *mut MSG, window: HANDLE, first: u32, last: u32, flags: u32) -> i32;
    fn PostMessageA(window: HANDLE, message: u32, first: usize, second: isize) -> i32;
    fn PostThreadMessageA(thread: u32, message: u32, first: usize, second: isize) -> i32;
    fn RegisterClassA(class: *const WNDCLASSA) -> u16;
    fn SetClassLongPtrA(window: HANDLE, what: i32, value: HANDLE) -> HANDLE;
    fn SetProcessDpiAwarenessContext(context: HANDLE) -> i32;
    fn SetWindowLongPtrA(window: HANDLE, what: i32, value: isize) -> isize;
    fn SetWindowPlacement(window: HANDLE, place: *const WINDOWPLACEMENT) -> i32;
    fn SetWindowPos(window: HANDLE, after: HANDLE, x: i32, y: i32, width: i32, height: i32, flags: u32) -> i32;
    "gdi32.dll":
    fn StretchDIBits(to: HANDLE, x: i32, y: i32, width: i32, height: i32, from_x: i32, from_y: i32, from_width: i32, from_height: i32, pixels: *const u32, info: *const BITMAPINFO, colours: u32, operation: u32) -> i32;
    "winmm.dll":
    fn timeBeginPeriod(milliseconds: u32) -> u32;
    fn waveOutGetPosition(device: HANDLE, position: *mut MMTIME, size: u32) -> u32;
    fn waveOutOpen(device: *mut HANDLE, number: u32, format: *const WAVEFORMATEX, callback: usize, pointer: usize, flags: u32) -> u32;
    fn waveOutPrepareHeader(device: HANDLE, header: *mut WAVEHDR, size: u32) -> u32;
    fn waveOutWrite(device: HANDLE, header: *mut WAVEHDR, size: u32) -> u32;
}

struct Functions(UnsafeCell<MaybeUninit<Table>>);

// SAFETY: only `load` writes it, before there is a second thread; afterwards it is only read.
unsafe impl Sync for Functions {}

static FUNCTIONS: Functions = Functions(UnsafeCell::new(MaybeUninit::uninit()));

/// # Safety
/// [`load`] has to have succeeded.
#[inline(always)]
unsafe fn table() -> &'static Table {
    // SAFETY: required of the caller.
    unsafe { (*FUNCTIONS.0.get()).assume_init_ref() }
}

pub fn default_procedure() -> *const c_void {
    // SAFETY: windows exist only after `load`.
    unsafe { table() }.DefWindowProcA as *const c_void
}

/// Looks up all functions, or returns a missing one's name or library. Windows 10 of 2017 has all.
///
/// # Safety
/// This has to be the first call.
pub unsafe fn load(
    load_library: LoadLibrary,
    get_function: GetProcAddress,
) -> Result<(), &'static str> {
    let mut slot: *mut *const c_void = FUNCTIONS.0.get().cast();
    let mut library = core::ptr::null_mut();
    for name in NAMES.split_terminator('\0') {
        // SAFETY: a NUL follows the name. The table has a slot for each function, in this order.
        unsafe {
            let found = if name.contains('.') {
                library = load_library(name.as_ptr());
                library.cast_const()
            } else {
                let function = get_function(library, name.as_ptr());
                slot.write(function);
                slot = slot.add(1);
                function
            };
            if found.is_null() {
                return Err(name);
            }
        }
    }
    Ok(())
}
