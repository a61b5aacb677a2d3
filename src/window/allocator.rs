//! Memory from C's allocator, and no more: std's own way there takes care of alignments that nobody asks
//! for, in 400 bytes.

use core::{
    alloc::{GlobalAlloc, Layout},
    ptr::null_mut,
};

/// The intro's global allocator.
pub struct Malloc;

/// What `malloc` aligns to, on 64-bit systems.
const ALIGNMENT: usize = 16;

// SAFETY: C's functions keep to the contract, but for alignments beyond theirs; those are refused.
unsafe impl GlobalAlloc for Malloc {
    #[inline]
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        if layout.align() > ALIGNMENT {
            return null_mut();
        }
        // SAFETY: any size may be asked for.
        unsafe { libc::malloc(layout.size()).cast() }
    }

    #[inline]
    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        if layout.align() > ALIGNMENT {
            return null_mut();
        }
        // SAFETY: any size may be asked for.
        unsafe { libc::calloc(1, layout.size()).cast() }
    }

    #[inline]
    unsafe fn realloc(&self, memory: *mut u8, _: Layout, size: usize) -> *mut u8 {
        // SAFETY: the caller vouches that the memory is from here.
        unsafe { libc::realloc(memory.cast(), size).cast() }
    }

    #[inline]
    unsafe fn dealloc(&self, memory: *mut u8, _: Layout) {
        // SAFETY: the caller vouches that the memory is from here.
        unsafe { libc::free(memory.cast()) }
    }
}
