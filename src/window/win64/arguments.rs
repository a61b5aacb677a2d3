//! The command line.

use core::slice::from_raw_parts;

use super::functions::{
    self, CommandLineToArgvW, ExitProcess, GetCommandLineW, GetProcAddress, LoadLibrary,
    timeBeginPeriod,
};
use crate::{line, system};

/// The words that follow the program's name on the command line.
pub struct Arguments {
    rest: &'static [*mut u16],
}

impl Arguments {
    /// Looks the functions of Windows up and prepares the process, as [`main!`](crate::main) says. Ends it if this Windows has not all
    /// of them.
    ///
    /// # Safety
    /// It has to be called first, with the functions of Windows that do so.
    #[doc(hidden)]
    #[must_use]
    pub unsafe fn start(load_library: LoadLibrary, get_function: GetProcAddress) -> Arguments {
        let mut count = 0;
        // SAFETY: the caller vouches for the functions, and there is no other thread. What Windows returns is as long as it says, and
        // stays.
        unsafe {
            let loaded = functions::load(load_library, get_function);
            // What this takes, and saying what is missing, is looked up first.
            system::start();
            if let Err(name) = loaded {
                line::complain(format_args!("this Windows has no {name}"));
                end(1);
            }
            // It sleeps by milliseconds.
            timeBeginPeriod(1);
            let all = CommandLineToArgvW(GetCommandLineW(), &mut count);
            let all = from_raw_parts(all, count as usize);
            Arguments {
                rest: all.get(1..).unwrap_or_default(),
            }
        }
    }
}

/// Ends the process with a code.
pub fn end(code: i32) -> ! {
    // SAFETY: it may be called at any time.
    unsafe { ExitProcess(code as u32) }
}

impl Iterator for Arguments {
    type Item = &'static [u8];

    /// A word, in which all that is not ASCII is a byte that is neither.
    fn next(&mut self) -> Option<&'static [u8]> {
        let (&first, rest) = self.rest.split_first()?;
        self.rest = rest;
        let (mut length, bytes) = (0, first.cast::<u8>());
        // SAFETY: the word ends in a NUL, is this program's to write to, and is taken once. Where its bytes go has been read.
        unsafe {
            while first.add(length).read() != 0 {
                let unit = first.add(length).read();
                bytes
                    .add(length)
                    .write(u8::try_from(unit).unwrap_or(u8::MAX));
                length += 1;
            }
            Some(from_raw_parts(bytes, length))
        }
    }
}
