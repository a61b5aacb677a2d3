use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering::SeqCst};

/// Counts calls of Rust's allocator, as a `#[global_allocator]`.
pub struct Counting(AtomicUsize);

impl Counting {
    #[must_use]
    #[expect(clippy::new_without_default, reason = "it is made for a static")]
    pub const fn new() -> Self {
        Self(AtomicUsize::new(0))
    }

    pub fn count(&self) -> usize {
        self.0.load(SeqCst)
    }
}

// SAFETY: all calls go to the system's allocator; the other methods call these.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        self.0.fetch_add(1, SeqCst);
        // SAFETY: required of the caller.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: required of the caller.
        unsafe { System.dealloc(pointer, layout) }
    }
}
