use core::ptr::null_mut;

use crate::backend::functions::{
    AttachConsole, CreateFileA, GetConsoleMode, GetLastError, GetStdHandle, MultiByteToWideChar,
    SetStdHandle, WriteConsoleW, WriteFile,
};

pub const OUTPUT: i32 = -11;
pub const ERROR: i32 = -12;

const PART: usize = 1024;

/// Prepares the process: a GUI program has no console, and uses its parent's.
///
/// # Safety
/// No other thread may be running.
pub unsafe fn start() {
    /// `ATTACH_PARENT_PROCESS`.
    const PARENT: u32 = u32::MAX;
    const READ_WRITE: u32 = 0xc000_0000;
    const SHARED: u32 = 3;
    const EXISTING: u32 = 3;
    // SAFETY: nothing uses the streams yet, and the name outlives the calls.
    unsafe {
        if AttachConsole(PARENT) == 0 {
            return;
        }
        for stream in [OUTPUT, ERROR] {
            // Keep streams that are files or pipes.
            if GetStdHandle(stream).is_null() {
                let (name, none) = (c"CONOUT$".as_ptr().cast(), null_mut());
                let console = CreateFileA(name, READ_WRITE, SHARED, none, EXISTING, 0, none);
                SetStdHandle(stream, console);
            }
        }
    }
}

pub fn heed_stops() {}

pub fn stops() -> u32 {
    0
}

#[must_use]
#[inline(never)]
pub fn is_terminal(stream: i32) -> bool {
    // SAFETY: any handle is allowed, and the result is writable.
    unsafe { GetConsoleMode(GetStdHandle(stream), &mut 0) != 0 }
}

/// Returns false on an error. Ignores a missing stream, as after a double click.
pub fn write(stream: i32, bytes: &[u8]) -> bool {
    /// The error of a missing stream, whose handle may be stale.
    const INVALID_HANDLE: u32 = 6;
    // SAFETY: it may be called at any time.
    let file = unsafe { GetStdHandle(stream) };
    let is_console = is_terminal(stream);
    bytes.chunks(PART).all(|part| {
        let (start, length, mut written) = (part.as_ptr(), part.len() as u32, 0);
        // SAFETY: pointers and lengths are from slices, which outlive the calls.
        unsafe {
            let is_written = if is_console {
                const UTF_8: u32 = 65001;
                let mut text = [0; PART];
                let to = text.as_mut_ptr();
                let count = MultiByteToWideChar(UTF_8, 0, start, length as i32, to, PART as i32);
                WriteConsoleW(file, to, count as u32, &mut written, null_mut())
            } else {
                WriteFile(file, start, length, &mut written, null_mut())
            };
            is_written != 0 || GetLastError() == INVALID_HANDLE
        }
    })
}
