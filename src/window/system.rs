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
