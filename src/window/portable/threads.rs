use std::ffi::c_void;
use std::sync::atomic::{AtomicU32, Ordering::SeqCst};
use std::sync::{Condvar, Mutex, PoisonError};
use std::thread::{Builder, JoinHandle, available_parallelism};

use crate::system;

pub struct Thread(JoinHandle<()>);

impl Thread {
    pub fn join(self) {
        // `main` aborts on a panic, so there is no error.
        let _ = self.0.join();
    }
}

struct Sent(*mut c_void);

// SAFETY: required of the caller of `spawn`.
unsafe impl Send for Sent {}

/// # Safety
/// The pointer has to be valid while the thread runs.
pub unsafe fn spawn(
    main: extern "C" fn(*mut c_void) -> *mut c_void,
    pointer: *mut c_void,
) -> Option<Thread> {
    let sent = Sent(pointer);
    let work = move || {
        let Sent(pointer) = { sent };
        main(pointer);
    };
    system::without_signals(|| Builder::new().spawn(work)).ok().map(Thread)
}

/// Shared by all waits: [`wake`] wakes every thread, whatever its word.
static WAITING: (Mutex<()>, Condvar) = (Mutex::new(()), Condvar::new());

pub fn wait(word: &AtomicU32, value: u32) {
    let (lock, changed) = &WAITING;
    let guard = lock.lock().unwrap_or_else(PoisonError::into_inner);
    // The word changes before `wake`, which takes the same lock, so no change is missed between the
    // load and the wait.
    if word.load(SeqCst) == value {
        drop(changed.wait(guard));
    }
}

pub fn wake(_: &AtomicU32) {
    let (lock, changed) = &WAITING;
    let _guard = lock.lock().unwrap_or_else(PoisonError::into_inner);
    changed.notify_all();
}

#[must_use]
pub fn processors() -> usize {
    available_parallelism().map_or(1, usize::from)
}
