use core::ffi::c_void;
use core::ptr::{null_mut, without_provenance_mut};
use core::sync::atomic::AtomicU32;

use windows_sys::Win32::{Foundation::HANDLE, System::Threading::INFINITE};

use super::functions::{
    CreateThread, GetProcessAffinityMask, WaitForSingleObject, WaitOnAddress, WakeByAddressAll,
};

pub struct Thread(HANDLE);

// SAFETY: any thread may wait for another.
unsafe impl Send for Thread {}

impl Thread {
    pub fn join(self) {
        // SAFETY: it has been started.
        unsafe { WaitForSingleObject(self.0, INFINITE) };
    }
}

#[repr(C)]
struct MainCall {
    main: extern "C" fn(*mut c_void) -> *mut c_void,
    pointer: *mut c_void,
}

unsafe extern "C" {
    fn eightfold_thread();
}

/// # Safety
/// The pointer has to be valid while the thread runs.
pub unsafe fn spawn(
    main: extern "C" fn(*mut c_void) -> *mut c_void,
    pointer: *mut c_void,
) -> Option<Thread> {
    let call = Box::into_raw(Box::new(MainCall { main, pointer }));
    // SAFETY: the call is never freed; the rest is required of the caller.
    let thread = unsafe {
        let start = eightfold_thread as *const c_void;
        CreateThread(null_mut(), 0, start, call.cast(), 0, null_mut())
    };
    (!thread.is_null()).then_some(Thread(thread))
}

pub fn wait(word: &AtomicU32, value: u32) {
    // SAFETY: both are valid, of four bytes.
    unsafe { WaitOnAddress(word.as_ptr(), &value, size_of::<u32>(), INFINITE) };
}

pub fn wake(word: &AtomicU32) {
    // SAFETY: the word is valid.
    unsafe { WakeByAddressAll(word.as_ptr()) };
}

/// Returns 1 to 64 (one processor group).
#[must_use]
pub fn processors() -> usize {
    const OWN: usize = usize::MAX;
    let [mut own, mut all] = [0_usize; 2];
    // SAFETY: the results are writable.
    unsafe { GetProcessAffinityMask(without_provenance_mut(OWN), &mut own, &mut all) };
    usize::max(own.count_ones() as usize, 1)
}
