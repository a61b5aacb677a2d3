//! A bump allocator, which never frees, for the few objects that are created once.

use core::alloc::{GlobalAlloc, Layout};
use core::cell::UnsafeCell;
use core::ptr::null_mut;
use core::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use crate::pool::Pool;

/// The heap's size in bytes: an object for each thread of the largest pool, their shared state, and
/// a few others.
const SIZE: usize = 8192;

const _: () = assert!(SIZE >= (Pool::MAX_THREADS + 64) * ALIGNMENT);

const ALIGNMENT: usize = 16;

#[repr(C, align(16))]
struct Heap {
    memory: UnsafeCell<[u8; SIZE]>,
    used: AtomicUsize,
}

// SAFETY: each part is handed out once.
unsafe impl Sync for Heap {}

#[global_allocator]
static HEAP: Heap = Heap { memory: UnsafeCell::new([0; SIZE]), used: AtomicUsize::new(0) };

// SAFETY: allocations do not overlap, and have the requested size and alignment.
unsafe impl GlobalAlloc for Heap {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let size = layout.size().next_multiple_of(ALIGNMENT);
        let start = self.used.fetch_add(size, Relaxed);
        if layout.align() > ALIGNMENT || start + size > SIZE {
            return null_mut();
        }
        // SAFETY: the offset is within the memory.
        unsafe { self.memory.get().cast::<u8>().add(start) }
    }

    unsafe fn dealloc(&self, _: *mut u8, _: Layout) {}
}
