//! Threads, and waiting for each other, by std.

use std::{
    ffi::c_void,
    sync::{
        Condvar, Mutex, PoisonError,
        atomic::{AtomicU32, Ordering::SeqCst},
    },
    thread::{Builder, JoinHandle, available_parallelism},
};

use crate::system;

/// A thread that has been started, and not waited for.
pub struct Thread(JoinHandle<()>);

impl Thread {
    /// Waits until it has ended.
    pub fn join(self) {
        // It does not panic: what it runs cannot be unwound.
        let _ = self.0.join();
    }
}

/// The pointer that a thread works on.
struct Sent(*mut c_void);

// SAFETY: whoever starts the thread vouches for it.
unsafe impl Send for Sent {}

/// Starts a thread, unless the system has no more.
///
/// # Safety
/// The thread's use of the pointer has to be right for as long as it runs.
pub unsafe fn spawn(
    main: extern "C" fn(*mut c_void) -> *mut c_void,
    pointer: *mut c_void,
) -> Option<Thread> {
    let sent = Sent(pointer);
    let work = move || {
        let Sent(pointer) = { sent };
        main(pointer);
    };
    // Signals are for the caller's thread.
    system::without_signals(|| Builder::new().spawn(work))
        .ok()
        .map(Thread)
}

/// Threads that wait for a word, whichever it is.
static WAITING: (Mutex<()>, Condvar) = (Mutex::new(()), Condvar::new());

/// Waits while a word has a value. It may return too early.
pub fn wait(word: &AtomicU32, value: u32) {
    let (lock, changed) = &WAITING;
    let guard = lock.lock().unwrap_or_else(PoisonError::into_inner);
    // Whoever changes the word wakes after that, under the same lock: between this look and the wait nobody can.
    if word.load(SeqCst) == value {
        drop(changed.wait(guard));
    }
}

/// Wakes all that wait for a word, and those that wait for others.
pub fn wake(_: &AtomicU32) {
    let (lock, changed) = &WAITING;
    let _guard = lock.lock().unwrap_or_else(PoisonError::into_inner);
    changed.notify_all();
}

/// The processors that this process may use, at least 1.
#[must_use]
pub fn processors() -> usize {
    available_parallelism().map_or(1, usize::from)
}
