use core::ffi::c_void;
use core::ptr::{null, null_mut};
use core::sync::atomic::AtomicU32;

use crate::system;

pub struct Thread(libc::pthread_t);

impl Thread {
    pub fn join(self) {
        // SAFETY: it is joined once, and never detached.
        unsafe { libc::pthread_join(self.0, null_mut()) };
    }
}

/// Starts a thread, unless the system refuses.
///
/// # Safety
/// The pointer has to be valid while the thread runs.
pub unsafe fn spawn(
    main: extern "C" fn(*mut c_void) -> *mut c_void,
    pointer: *mut c_void,
) -> Option<Thread> {
    let mut thread = 0;
    let failed = system::without_signals(|| {
        // SAFETY: `thread` is writable; the rest is required of the caller.
        unsafe { libc::pthread_create(&mut thread, null(), main, pointer) }
    });
    (failed == 0).then_some(Thread(thread))
}

/// Waits while a word has a value. It may return early.
pub fn wait(word: &AtomicU32, value: u32) {
    futex(word, libc::FUTEX_WAIT, value);
}

pub fn wake(word: &AtomicU32) {
    futex(word, libc::FUTEX_WAKE, i32::MAX as u32);
}

fn futex(word: &AtomicU32, operation: i32, value: u32) {
    let operation = operation | libc::FUTEX_PRIVATE_FLAG;
    let no_limit = null::<libc::timespec>();
    // SAFETY: the word is valid.
    unsafe { libc::syscall(libc::SYS_futex, word.as_ptr(), operation, value, no_limit) };
}

#[must_use]
pub fn processors() -> usize {
    // Bits for 8192 processors, more than `cpu_set_t` has.
    let mut set = [0_u8; 1024];
    // SAFETY: the set has this size.
    unsafe { libc::sched_getaffinity(0, set.len(), set.as_mut_ptr().cast()) };
    let bits = (0..8 * set.len()).filter(|bit| set[bit / 8] >> (bit % 8) & 1 != 0);
    usize::max(bits.count(), 1)
}
