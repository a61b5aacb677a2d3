use core::{ptr::null_mut, slice};

use crate::{enlarge::MAX_SMALL, line, render_target::MAX_PIXELS};

pub fn pixels() -> &'static mut [u32] {
    allocate(MAX_PIXELS)
}

pub fn small() -> &'static mut [u32] {
    allocate(MAX_SMALL)
}

/// Returns zeroed pixels, committed when they are written. Ends the process if no address space is
/// left.
#[inline(never)]
pub fn allocate(count: usize) -> &'static mut [u32] {
    // SAFETY: the mapping is new, and is never unmapped.
    unsafe {
        let memory = libc::mmap(
            null_mut(),
            count * size_of::<u32>(),
            libc::PROT_READ | libc::PROT_WRITE,
            libc::MAP_PRIVATE | libc::MAP_ANONYMOUS | libc::MAP_NORESERVE,
            -1,
            0,
        );
        if memory == libc::MAP_FAILED {
            line::complain("memory is exhausted", "");
            libc::_exit(1);
        }
        slice::from_raw_parts_mut(memory.cast(), count)
    }
}
