use core::slice::from_raw_parts;

use super::functions::{self, CommandLineToArgvW, ExitProcess, GetCommandLineW, timeBeginPeriod};
pub use super::functions::{GetProcAddress as Second, LoadLibrary as First};
use crate::{line, system};

pub struct Arguments {
    rest: &'static [*mut u16],
}

impl Arguments {
    /// Loads the functions of Windows and prepares the process, or ends it if a function is
    /// missing.
    ///
    /// # Safety
    /// This has to be the first call, with these functions of Windows.
    #[doc(hidden)]
    #[must_use]
    pub unsafe fn start(load_library: First, get_function: Second) -> Arguments {
        let mut count = 0;
        // SAFETY: the caller guarantees the functions, and there is no other thread. Windows'
        // arguments have this length and stay valid.
        unsafe {
            let loaded = functions::load(load_library, get_function);
            // The functions for the start and the message come first in the table.
            system::start();
            if let Err(name) = loaded {
                line::complain(name, " is missing");
                end(1);
            }
            timeBeginPeriod(1);
            let all = CommandLineToArgvW(GetCommandLineW(), &mut count);
            let all = from_raw_parts(all, count as usize);
            Arguments { rest: all.get(1..).unwrap_or_default() }
        }
    }
}

pub fn end(code: i32) -> ! {
    // SAFETY: it may be called at any time.
    unsafe { ExitProcess(code as u32) }
}

impl Iterator for Arguments {
    type Item = &'static [u8];

    /// Returns an argument, with 0xff for each unit beyond a byte.
    fn next(&mut self) -> Option<&'static [u8]> {
        let (&first, rest) = self.rest.split_first()?;
        self.rest = rest;
        let (mut length, bytes) = (0, first.cast::<u8>());
        // SAFETY: the argument ends with a NUL, is writable, and is returned once. Bytes overwrite
        // only units that have been read.
        unsafe {
            while first.add(length).read() != 0 {
                let unit = first.add(length).read();
                bytes.add(length).write(u8::try_from(unit).unwrap_or(u8::MAX));
                length += 1;
            }
            Some(from_raw_parts(bytes, length))
        }
    }
}
