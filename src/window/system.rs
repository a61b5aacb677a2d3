//! Calls of the system, by number.

/// Calls the system: `call!(SYS_read, file, memory, length)`. Like a function of libc, it returns -1 and
/// sets `errno` where that fails.
///
/// A function of libc's own costs the program 66 bytes to be found by its name, a number 5.
macro_rules! call {
    ($number:ident $(, $argument:expr)* $(,)?) => {
        libc::syscall(libc::$number $(, $argument as core::ffi::c_long)*)
    };
}

pub(crate) use call;

use core::ffi::{CStr, c_int, c_long};

/// Opens a file for reading. Its descriptor, or -1.
pub(crate) fn open(path: &CStr) -> c_int {
    const FLAGS: c_int = libc::O_RDONLY | libc::O_CLOEXEC;
    // SAFETY: no memory is shared with the call but the path.
    unsafe { call!(SYS_openat, libc::AT_FDCWD, path.as_ptr(), FLAGS) as c_int }
}

/// Writes some bytes to a file descriptor, and returns how many, or -1.
pub(crate) fn write(file: c_int, bytes: &[u8]) -> c_long {
    // SAFETY: the pointer and the length are those of a slice.
    unsafe { call!(SYS_write, file, bytes.as_ptr(), bytes.len()) }
}
