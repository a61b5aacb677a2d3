//! Memory of fixed size, part of the program itself.

use core::{
    cell::UnsafeCell,
    sync::atomic::{AtomicBool, Ordering::AcqRel},
};

use crate::abort::eightfold_abort;

/// A value that lives as long as the program and is lent out once.
///
/// In a `static` whose bits are all zero it takes no room in the program's file, and memory only
/// where it has been written.
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
    /// The second time, that is the end of the process.
    #[allow(clippy::mut_from_ref, reason = "it happens once")]
    pub fn take(&'static self) -> &'static mut T {
        take_once(&self.taken);
        // SAFETY: the flag lets one caller through, ever.
        unsafe { &mut *self.value.get() }
    }
}

/// Sets the flag; apart, so that the check is in the program once.
#[inline(never)]
fn take_once(taken: &AtomicBool) {
    if taken.swap(true, AcqRel) {
        eightfold_abort();
    }
}
