use core::ffi::{c_char, c_void};

/// `PAGE_READONLY`.
pub const READ: u32 = 2;
/// `PAGE_READWRITE`.
pub const READ_WRITE: u32 = 4;
/// `PAGE_EXECUTE_READ`.
pub const READ_EXECUTE: u32 = 0x20;
/// `MEM_COMMIT | MEM_RESERVE`.
pub const COMMIT_RESERVE: u32 = 0x3000;
/// `MEM_RELEASE`.
pub const RELEASE: u32 = 0x8000;

/// The import address table, in the order of `FUNCTIONS` in `src/pack/executable/windows.rs`.
/// `first.s` uses offsets.
#[repr(C)]
pub struct System {
    pub load_library: unsafe extern "win64" fn(name: *const u8) -> *mut c_void,
    pub get_function: unsafe extern "win64" fn(library: *mut c_void, name: *const u8) -> usize,
    pub allocate:
        unsafe extern "win64" fn(address: usize, size: usize, kind: u32, protection: u32) -> usize,
    pub protect:
        unsafe extern "win64" fn(address: usize, size: usize, to: u32, was: *mut u32) -> i32,
    pub free: unsafe extern "win64" fn(address: usize, size: usize, kind: u32) -> i32,
    pub attach_console: unsafe extern "win64" fn(process: u32) -> i32,
    pub stream: unsafe extern "win64" fn(number: u32) -> *mut c_void,
    pub write: unsafe extern "win64" fn(
        stream: *mut c_void,
        bytes: *const c_char,
        count: u32,
        written: *mut u32,
        overlapped: *mut c_void,
    ) -> i32,
    pub exit: unsafe extern "win64" fn(code: u32) -> !,
}

/// Changes access rights. Returns false if Windows refuses.
///
/// # Safety
/// No code may rely on the removed rights.
#[inline(always)]
pub unsafe fn protect(system: &System, address: usize, size: usize, to: u32) -> bool {
    let mut was = 0;
    // SAFETY: required of the caller.
    unsafe { (system.protect)(address, size, to, &mut was) != 0 }
}
