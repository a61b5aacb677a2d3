//! Standard streams of Windows, by std.

use std::{
    fs::File,
    io::{self, IsTerminal, Write},
    os::windows::io::IntoRawHandle,
};

use winapi::um::{processenv, winbase, wincon};

/// The number of standard output.
pub const OUTPUT: i32 = 1;
/// The number of standard error.
pub const ERROR: i32 = 2;

/// Prepares the process: a program for windows has no console, and writes to the one that it was started from.
///
/// # Safety
/// No other thread may be running yet.
pub unsafe fn start() {
    // SAFETY: nobody else uses the streams yet.
    unsafe {
        if wincon::AttachConsole(wincon::ATTACH_PARENT_PROCESS) == 0 {
            return;
        }
        for stream in [winbase::STD_OUTPUT_HANDLE, winbase::STD_ERROR_HANDLE] {
            // One that goes to a file or a pipe is left as it is.
            if processenv::GetStdHandle(stream).is_null()
                && let Ok(console) = File::options().read(true).write(true).open("CONOUT$")
            {
                processenv::SetStdHandle(stream, console.into_raw_handle().cast());
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

/// Whether this process ignores a signal. (Windows has none to ignore.)
#[must_use]
pub fn is_signal_ignored(_: i32) -> bool {
    false
}

/// Starts something. (Signals are a matter of Unix.)
pub fn without_signals<T>(start: impl FnOnce() -> T) -> T {
    start()
}

/// Whether a stream is a console.
pub fn is_terminal(stream: i32) -> bool {
    match stream {
        OUTPUT => io::stdout().is_terminal(),
        _ => io::stderr().is_terminal(),
    }
}

/// Writes everything to a stream. False if that fails.
pub fn write(stream: i32, bytes: &[u8]) -> bool {
    let to: &mut dyn Write = match stream {
        OUTPUT => &mut io::stdout(),
        _ => &mut io::stderr(),
    };
    to.write_all(bytes).and_then(|()| to.flush()).is_ok()
}
