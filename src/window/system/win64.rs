//! Standard streams and the console of Windows, by its own functions.

use core::ptr::null_mut;

use crate::backend::functions::{
    AttachConsole, CreateFileA, GetConsoleMode, GetLastError, GetStdHandle, MultiByteToWideChar,
    SetStdHandle, WriteConsoleW, WriteFile,
};

/// The number of standard output.
pub const OUTPUT: i32 = -11;
/// The number of standard error.
pub const ERROR: i32 = -12;

/// Bytes that are written to a console at a time.
const PART: usize = 1024;

/// Prepares the process: a program for windows has no console, and writes to the one that it was started from.
///
/// # Safety
/// No other thread may be running yet.
pub unsafe fn start() {
    /// Stands for the process that started this one.
    const PARENT: u32 = u32::MAX;
    /// Whether it may be read and written.
    const READ_WRITE: u32 = 0xc000_0000;
    /// Others may, too.
    const SHARED: u32 = 3;
    const EXISTING: u32 = 3;
    // SAFETY: nobody else uses the streams yet, and the name outlives the calls.
    unsafe {
        if AttachConsole(PARENT) == 0 {
            return;
        }
        for stream in [OUTPUT, ERROR] {
            // One that goes to a file or a pipe is left as it is.
            if GetStdHandle(stream).is_null() {
                let (name, none) = (c"CONOUT$".as_ptr().cast(), null_mut());
                let console = CreateFileA(name, READ_WRITE, SHARED, none, EXISTING, 0, none);
                SetStdHandle(stream, console);
            }
        }
    }
}

/// Counts stops. (Windows has none.)
pub fn heed_stops() {}

/// How often the process was stopped.
pub fn stops() -> u32 {
    0
}

/// Whether a stream is a console.
pub fn is_terminal(stream: i32) -> bool {
    // SAFETY: it may be asked of any file, and there is room for the answer.
    unsafe { GetConsoleMode(GetStdHandle(stream), &mut 0) != 0 }
}

/// Writes everything to a stream; to none, if there is none, as after a double click, when its handle may be of something else. False
/// if that fails.
pub fn write(stream: i32, bytes: &[u8]) -> bool {
    /// What says that there is none.
    const INVALID_HANDLE: u32 = 6;
    // SAFETY: it may be called at any time.
    let file = unsafe { GetStdHandle(stream) };
    let is_console = is_terminal(stream);
    bytes.chunks(PART).all(|part| {
        let (start, length, mut written) = (part.as_ptr(), part.len() as u32, 0);
        // SAFETY: pointers and lengths are those of slices, and outlive the calls.
        unsafe {
            let is_written = if is_console {
                /// The number of UTF-8.
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
