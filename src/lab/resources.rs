//! One line and an exit code for panics and refused memory.

use eightfold_scene_file::one_line;
use std::alloc::{GlobalAlloc, Layout, System};
use std::io::{Write, stderr};
use std::process::exit;
use std::{fs, panic};

/// The minimum stack in kB; 384 kB overflowed.
const STACK: u64 = 1024;

/// Prints a message. Ignores errors, such as a closed terminal.
pub fn complain(message: &str) {
    let _ = writeln!(stderr(), "{}", one_line(message));
}

/// Ends the process at a panic, or if the stack is too small.
pub fn start() {
    panic::set_hook(Box::new(|panic| {
        let why = panic.payload_as_str().unwrap_or("the lab failed");
        let place = panic.location().map(ToString::to_string);
        complain(&format!("{why} ({})", place.unwrap_or_default()));
        exit(1);
    }));
    let limits = fs::read_to_string("/proc/self/limits").unwrap_or_default();
    let limit = limits.lines().find_map(|line| line.strip_prefix("Max stack size"));
    let bytes = limit.and_then(|limit| limit.split_whitespace().next()?.parse::<u64>().ok());
    if let Some(kilobytes) = bytes.map(|bytes| bytes >> 10)
        && kilobytes < STACK
    {
        complain(&format!("stack limit in kB is {kilobytes}; must be {STACK} or more"));
        exit(1);
    }
}

/// The system's heap. The process ends if it is full.
pub struct Heap;

// SAFETY: all calls go to the system's allocator.
unsafe impl GlobalAlloc for Heap {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller's contract is the same.
        let block = unsafe { System.alloc(layout) };
        if block.is_null() {
            // Without allocation.
            let bytes = layout.size();
            let _ = writeln!(stderr(), "memory is full; {bytes} bytes more must be free");
            exit(1);
        }
        block
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        // SAFETY: the caller's contract is the same.
        unsafe { System.dealloc(block, layout) }
    }
}
