//! The command line, as std gives it.

use std::{
    env,
    ffi::{OsString, c_char, c_int},
    panic, vec,
};

use crate::{system, terminal};

/// The words that follow the program's name on the command line.
pub struct Arguments {
    rest: vec::IntoIter<OsString>,
}

impl Arguments {
    /// Takes the arguments and prepares the process, as [`main!`](crate::main) says.
    ///
    /// # Safety
    /// No other thread may be running yet.
    #[doc(hidden)]
    #[must_use]
    pub unsafe fn start(_: c_int, _: *const *const c_char) -> Arguments {
        // SAFETY: there is no other thread.
        unsafe { system::start() };
        let report = panic::take_hook();
        panic::set_hook(Box::new(move |mistake| {
            terminal::restore();
            report(mistake);
        }));
        Arguments {
            rest: env::args_os().skip(1).collect::<Vec<_>>().into_iter(),
        }
    }
}

impl Iterator for Arguments {
    type Item = &'static [u8];

    fn next(&mut self) -> Option<&'static [u8]> {
        Some(self.rest.next()?.into_encoded_bytes().leak())
    }
}
