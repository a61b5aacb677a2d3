//! The command line, as C gives it.

use core::ffi::{CStr, c_char, c_int};

use crate::{system, terminal};

/// Defines the C `main`, which calls a `fn(Arguments) -> i32` for the exit code.
///
/// Use it in a crate with `#![no_main]`. Rust's own start of a program adds 9,564 bytes to the packed intro, most of them to
/// explain a stack overflow, and std's way to the arguments 432. What matters of that start is here: a broken pipe is an error
/// of the write, not a signal, and the standard streams are open.
#[macro_export]
macro_rules! main {
    ($run:path) => {
        #[unsafe(no_mangle)]
        extern "C" fn main(
            count: core::ffi::c_int,
            values: *const *const core::ffi::c_char,
        ) -> core::ffi::c_int {
            // SAFETY: these are the arguments of the C `main`, and this is the start of it.
            let arguments = unsafe { $crate::arguments::Arguments::start(count, values) };
            let run: fn($crate::arguments::Arguments) -> i32 = $run;
            run(arguments)
        }

        // What the build script puts in place of functions of std.
        #[cfg(diet)]
        core::arch::global_asm!(
            include_str!(concat!(env!("OUT_DIR"), "/diet.s")),
            options(att_syntax)
        );
    };
}

/// What follows the program's name on the command line.
pub struct Arguments {
    rest: &'static [*const c_char],
}

impl Arguments {
    /// Takes the arguments and prepares the process, as [`main!`] says.
    ///
    /// # Safety
    /// `count` and `values` have to be those of the C `main`, with no other thread running yet.
    #[doc(hidden)]
    #[must_use]
    pub unsafe fn start(count: c_int, values: *const *const c_char) -> Arguments {
        // SAFETY: the caller vouches for `count` and `values`, which live as long as the process.
        let all = unsafe { core::slice::from_raw_parts(values, count.max(0) as usize) };
        // SAFETY: nobody relies on what is done on SIGPIPE.
        unsafe { terminal::on_signal(libc::SIGPIPE, libc::SIG_IGN) };
        open_standard_streams();
        Arguments {
            rest: all.get(1..).unwrap_or_default(),
        }
    }
}

impl Iterator for Arguments {
    type Item = &'static [u8];

    fn next(&mut self) -> Option<&'static [u8]> {
        let (first, rest) = self.rest.split_first()?;
        self.rest = rest;
        // SAFETY: each argument of the C `main` is a string with its NUL that lives on.
        Some(unsafe { CStr::from_ptr(*first) }.to_bytes())
    }
}

/// Puts something where standard input, output or error is closed, so that no file or display opened
/// later takes its number and is written to by mistake.
///
/// It is open for reading only: writing to it fails, as it would have when closed. One more stays open,
/// as the sign that the first three are.
fn open_standard_streams() {
    while (0..=2).contains(&system::open(c"/dev/null")) {}
}
