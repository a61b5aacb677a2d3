//! Threads, and waiting for each other, by libc.

use core::{
    ffi::c_void,
    ptr::{null, null_mut},
    sync::atomic::AtomicU32,
};

use crate::system;

/// A thread that has been started, and not waited for.
pub struct Thread(libc::pthread_t);

impl Thread {
    /// Waits until it has ended.
    pub fn join(self) {
        // SAFETY: it is joined once, and never detached.
        unsafe { libc::pthread_join(self.0, null_mut()) };
    }
}

/// Starts a thread, unless the system has no more.
///
/// # Safety
/// The thread's use of the pointer has to be right for as long as it runs.
pub unsafe fn spawn(
    main: extern "C" fn(*mut c_void) -> *mut c_void,
    pointer: *mut c_void,
) -> Option<Thread> {
    let mut thread = 0;
    // Signals are for the caller's thread.
    let failed = system::without_signals(|| {
        // SAFETY: there is room for the thread's name. The caller vouches for the rest.
        unsafe { libc::pthread_create(&mut thread, null(), main, pointer) }
    });
    (failed == 0).then_some(Thread(thread))
}

/// Waits while a word has a value. It may return too early.
pub fn wait(word: &AtomicU32, value: u32) {
    futex(word, libc::FUTEX_WAIT, value);
}

/// Wakes all that wait for a word.
pub fn wake(word: &AtomicU32) {
    futex(word, libc::FUTEX_WAKE, i32::MAX as u32);
}

/// Asks the system to wait for a word or to wake.
fn futex(word: &AtomicU32, operation: i32, value: u32) {
    let operation = operation | libc::FUTEX_PRIVATE_FLAG;
    let no_limit = null::<libc::timespec>();
    // SAFETY: the word is there. (libc has no function of its own for it.)
    unsafe { libc::syscall(libc::SYS_futex, word.as_ptr(), operation, value, no_limit) };
}

/// The processors that this process may use, at least 1.
#[must_use]
pub fn processors() -> usize {
    // A bit for each of 8192, which are more than `cpu_set_t` has.
    let mut set = [0_u64; 128];
    // SAFETY: the set is as long as it says.
    unsafe { libc::sched_getaffinity(0, size_of_val(&set), set.as_mut_ptr().cast()) };
    let count: u32 = set.iter().map(|word| word.count_ones()).sum();
    usize::max(count as usize, 1)
}
