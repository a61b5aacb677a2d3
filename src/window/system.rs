//! Files of the system, by their numbers.

use core::ffi::{CStr, c_int};

/// Opens a file for reading. Its descriptor, or -1.
pub(crate) fn open(path: &CStr) -> c_int {
    // SAFETY: the path outlives the call.
    unsafe { libc::open(path.as_ptr(), libc::O_RDONLY | libc::O_CLOEXEC) }
}

/// Writes some bytes to a file descriptor, and returns how many, or -1.
pub(crate) fn write(file: c_int, bytes: &[u8]) -> isize {
    // SAFETY: the pointer and the length are those of a slice.
    unsafe { libc::write(file, bytes.as_ptr().cast(), bytes.len()) }
}

/// Why the last call of this thread failed.
pub(crate) fn error() -> c_int {
    // SAFETY: errno is this thread's own.
    unsafe { *libc::__errno_location() }
}

/// Waits until a file that was full takes more, or so many milliseconds; without end if they are negative. False if it is full
/// still.
pub(crate) fn wait_for_room(file: c_int, milliseconds: c_int) -> bool {
    let mut room = libc::pollfd {
        fd: file,
        events: libc::POLLOUT,
        revents: 0,
    };
    // SAFETY: there is one of them.
    unsafe { libc::poll(&mut room, 1, milliseconds) != 0 }
}

/// Has writing to a terminal not wait for room any more, for this process alone: others that have the same terminal wait as
/// before. Does nothing if the terminal can't be opened by this path of its descriptor.
pub(crate) fn never_wait(file: c_int, path: &CStr) {
    let flags = libc::O_WRONLY | libc::O_NONBLOCK | libc::O_NOCTTY | libc::O_CLOEXEC;
    // SAFETY: the path outlives the call.
    unsafe {
        let own = libc::open(path.as_ptr(), flags);
        libc::dup2(own, file);
    }
}
