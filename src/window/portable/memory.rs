//! Memory for frames, from the system.

use std::{
    alloc::{Layout, alloc_zeroed},
    process, slice,
};

use crate::{line, screen::MOST_PIXELS};

/// Memory for two frames, zero to begin with, which the system gives where it is written to. Ends the process where there is
/// none left.
pub fn pixels() -> &'static mut [u32] {
    const COUNT: usize = 2 * MOST_PIXELS;
    // SAFETY: there are pixels, of which zero is a value, and nobody else has their memory or gives it back.
    unsafe {
        let memory = alloc_zeroed(Layout::new::<[u32; COUNT]>());
        if memory.is_null() {
            line::complain(format_args!("no memory for frames"));
            process::exit(1);
        }
        slice::from_raw_parts_mut(memory.cast(), COUNT)
    }
}
