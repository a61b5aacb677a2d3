use core::ffi::{CStr, c_char, c_int};

use crate::system;

/// The entry point's parameters: `argc` and `argv`; for Windows, `LoadLibraryA` and
/// `GetProcAddress`.
pub type First = c_int;
pub type Second = *const *const c_char;

pub struct Arguments {
    rest: &'static [*const c_char],
}

impl Arguments {
    /// Prepares the process and its arguments. [`main!`](crate::main) calls it first.
    ///
    /// # Safety
    /// `count` and `values` must be C's `argc` and `argv`, and no other thread may run.
    #[doc(hidden)]
    #[must_use]
    pub unsafe fn start(count: First, values: Second) -> Arguments {
        // SAFETY: the caller guarantees `count` and `values`, which live as long as the process.
        let all = unsafe { core::slice::from_raw_parts(values, count.max(0) as usize) };
        // SAFETY: there is no other thread.
        unsafe { system::start() };
        Arguments { rest: all.get(1..).unwrap_or_default() }
    }
}

/// Returns the exit code to the caller of `main`. On Windows, ends the process.
#[doc(hidden)]
#[must_use]
pub fn end(code: i32) -> i32 {
    code
}

impl Iterator for Arguments {
    type Item = &'static [u8];

    fn next(&mut self) -> Option<&'static [u8]> {
        let (first, rest) = self.rest.split_first()?;
        self.rest = rest;
        // SAFETY: each argument of the C `main` is a NUL-terminated string.
        Some(unsafe { CStr::from_ptr(*first) }.to_bytes())
    }
}
