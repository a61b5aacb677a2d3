//! Memory for frames, from the system.

use core::{ptr::null_mut, slice};

use crate::{line, screen::MOST_PIXELS};

/// Memory for two frames, zero to begin with, which the system gives where it is written to. Ends the process where there are no
/// addresses left for it.
pub fn pixels() -> &'static mut [u32] {
    const COUNT: usize = 2 * MOST_PIXELS;
    // SAFETY: nobody else has what is mapped here, and nobody unmaps it.
    unsafe {
        let memory = libc::mmap(
            null_mut(),
            COUNT * size_of::<u32>(),
            libc::PROT_READ | libc::PROT_WRITE,
            libc::MAP_PRIVATE | libc::MAP_ANONYMOUS | libc::MAP_NORESERVE,
            -1,
            0,
        );
        if memory == libc::MAP_FAILED {
            line::complain(format_args!("no memory for frames"));
            libc::_exit(1);
        }
        slice::from_raw_parts_mut(memory.cast(), COUNT)
    }
}
