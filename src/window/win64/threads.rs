//! Threads, and waiting for each other.

use core::{
    arch::global_asm,
    ffi::c_void,
    ptr::{null_mut, without_provenance_mut},
    sync::atomic::AtomicU32,
};

use super::{
    functions::{
        CreateThread, GetProcessAffinityMask, WaitForSingleObject, WaitOnAddress, WakeByAddressAll,
    },
    types::Handle,
};

/// Without end, in milliseconds.
const INFINITE: u32 = u32::MAX;

/// A thread that has been started, and not waited for.
pub struct Thread(Handle);

// SAFETY: the system lets any thread wait for another.
unsafe impl Send for Thread {}

impl Thread {
    /// Waits until it has ended.
    pub fn join(self) {
        // SAFETY: it has been started.
        unsafe { WaitForSingleObject(self.0, INFINITE) };
    }
}

/// What a thread does, and the pointer that it works on.
#[repr(C)]
struct Work {
    main: extern "C" fn(*mut c_void) -> *mut c_void,
    pointer: *mut c_void,
}

// Windows begins a thread here, with its work in `rcx`, and minds no registers when it ends.
global_asm!(
    ".section .text.eightfold_thread, \"ax\"",
    "eightfold_thread:",
    "push rax",
    "mov rdi, [rcx + 8]",
    "call [rcx]",
    "pop rcx",
    "ret",
);

unsafe extern "C" {
    fn eightfold_thread();
}

/// Starts a thread, unless the system has no more.
///
/// # Safety
/// The thread's use of the pointer has to be right for as long as it runs.
pub unsafe fn spawn(
    main: extern "C" fn(*mut c_void) -> *mut c_void,
    pointer: *mut c_void,
) -> Option<Thread> {
    let work = Box::into_raw(Box::new(Work { main, pointer }));
    // SAFETY: the work lasts. The caller vouches for the rest.
    let thread = unsafe {
        let start = eightfold_thread as *const c_void;
        CreateThread(null_mut(), 0, start, work.cast(), 0, null_mut())
    };
    (!thread.is_null()).then_some(Thread(thread))
}

/// Waits while a word has a value. It may return too early.
pub fn wait(word: &AtomicU32, value: u32) {
    // SAFETY: both are there, of four bytes.
    unsafe { WaitOnAddress(word.as_ptr(), &value, size_of::<u32>(), INFINITE) };
}

/// Wakes all that wait for a word.
pub fn wake(word: &AtomicU32) {
    // SAFETY: the word is there.
    unsafe { WakeByAddressAll(word.as_ptr()) };
}

/// The processors that this process may use, at least 1, of the 64 that it begins with.
#[must_use]
pub fn processors() -> usize {
    /// Stands for this process.
    const OWN: usize = usize::MAX;
    let [mut own, mut all] = [0_usize; 2];
    // SAFETY: there is room for the answers.
    unsafe { GetProcessAffinityMask(without_provenance_mut(OWN), &mut own, &mut all) };
    usize::max(own.count_ones() as usize, 1)
}
