use core::{ptr::null_mut, slice};

use crate::{line, render_target::MOST_PIXELS};

/// Returns zeroed memory for two frames, committed when it is written. Ends the process if no address space is left.
pub fn pixels() -> &'static mut [u32] {
    const COUNT: usize = 2 * MOST_PIXELS;
    // SAFETY: the mapping is new, and is never unmapped.
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
            line::complaint().text("memory is exhausted\n").flush();
            libc::_exit(1);
        }
        slice::from_raw_parts_mut(memory.cast(), COUNT)
    }
}
