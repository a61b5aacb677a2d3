//! Values too large for a stack, without `unsafe` where they are used.

use core::{
    cell::UnsafeCell,
    sync::atomic::{AtomicBool, Ordering::AcqRel},
};

/// A value in a `static` that lives as long as the program and is lent out once.
///
/// If all its bits are zero, it takes no room in the program's file, and memory only where it has been written: of the
/// memory for the largest frame and the most threads, what a run needs. `Box::new` would copy it from the stack.
pub struct Fixed<T> {
    taken: AtomicBool,
    value: UnsafeCell<T>,
}

// SAFETY: only one caller ever gets to the value, from whichever thread.
unsafe impl<T: Send> Sync for Fixed<T> {}

impl<T> Fixed<T> {
    /// Holds a value.
    pub const fn new(value: T) -> Fixed<T> {
        Fixed {
            taken: AtomicBool::new(false),
            value: UnsafeCell::new(value),
        }
    }

    /// Lends the value out for good.
    ///
    /// # Panics
    /// If it is lent out already.
    #[allow(clippy::mut_from_ref, reason = "it happens once")]
    pub fn take(&'static self) -> &'static mut T {
        assert!(!self.taken.swap(true, AcqRel), "lent out already");
        // SAFETY: the flag lets one caller through, ever.
        unsafe { &mut *self.value.get() }
    }
}
