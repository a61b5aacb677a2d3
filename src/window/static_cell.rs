use core::cell::UnsafeCell;
use core::sync::atomic::{AtomicBool, Ordering::AcqRel};

/// A value in a `static` that is borrowed once, for the rest of the program.
///
/// Zeroed values take no space in the executable. `Box::new` would copy the value from the stack.
pub struct StaticCell<T> {
    taken: AtomicBool,
    value: UnsafeCell<T>,
}

// SAFETY: the flag gives the value to one caller only.
unsafe impl<T: Send> Sync for StaticCell<T> {}

impl<T> StaticCell<T> {
    pub const fn new(value: T) -> StaticCell<T> {
        StaticCell { taken: AtomicBool::new(false), value: UnsafeCell::new(value) }
    }

    /// # Panics
    /// If it was taken before.
    #[allow(clippy::mut_from_ref, reason = "it happens once")]
    pub fn take(&'static self) -> &'static mut T {
        assert!(!self.taken.swap(true, AcqRel), "lent out already");
        // SAFETY: the flag lets one caller through, ever.
        unsafe { &mut *self.value.get() }
    }
}
