//! Memory for the few things that are made once, and last.

use core::{
    alloc::{GlobalAlloc, Layout},
    cell::UnsafeCell,
    ptr::null_mut,
    sync::atomic::{AtomicUsize, Ordering::Relaxed},
};

use crate::pool::Pool;

/// Bytes that there are: enough for what each of the most threads of a pool, and the few others, is started with, and what they share.
const SIZE: usize = 8192;

const _: () = assert!(SIZE >= (Pool::MOST + 64) * ALIGNMENT);

/// What each part is a multiple of, and aligned to.
const ALIGNMENT: usize = 16;

/// Memory of fixed size, of which each thing gets the next part, and which nothing is given back to.
#[repr(C, align(16))]
struct Heap {
    memory: UnsafeCell<[u8; SIZE]>,
    used: AtomicUsize,
}

// SAFETY: each part is handed out once.
unsafe impl Sync for Heap {}

#[global_allocator]
static HEAP: Heap = Heap {
    memory: UnsafeCell::new([0; SIZE]),
    used: AtomicUsize::new(0),
};

// SAFETY: parts do not overlap, and are as large and as aligned as is asked for.
unsafe impl GlobalAlloc for Heap {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let size = layout.size().next_multiple_of(ALIGNMENT);
        let start = self.used.fetch_add(size, Relaxed);
        if layout.align() > ALIGNMENT || start + size > SIZE {
            return null_mut();
        }
        // SAFETY: it is inside of the memory.
        unsafe { self.memory.get().cast::<u8>().add(start) }
    }

    unsafe fn dealloc(&self, _: *mut u8, _: Layout) {}
}
