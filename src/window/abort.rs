//! What stands in for functions of std in the intro.
//!
//! The intro is linked without std's panic machinery and formatting, which are larger than all the
//! rest of it: `build.rs` redirects the functions that lead there to these. In other programs nobody
//! calls them.
//!
//! What must report an error never goes through a panic, so that is only for mistakes in the code.
//! What a dependency formats or prints nobody gets to see: the intro has messages of its own.

use std::{
    ffi::{CStr, CString, FromBytesWithNulError, NulError},
    fmt::Arguments,
    time::{Duration, Instant},
};

use crate::{line, terminal};

/// Instead of a panic: gives the terminal back, says one line on standard error and aborts.
#[unsafe(no_mangle)]
pub extern "C" fn eightfold_abort() -> ! {
    terminal::restore();
    line::write(
        line::ERROR,
        b"eightfold: a mistake in the program ended it\n",
    );
    // SAFETY: `abort` may be called at any time.
    unsafe { libc::abort() }
}

/// Instead of a function that returns nothing, or a result of which zero is `Ok(())`: does nothing.
#[unsafe(no_mangle)]
pub extern "C" fn eightfold_ignore() -> usize {
    0
}

/// Instead of `format!`: no text.
#[unsafe(no_mangle)]
pub fn eightfold_format(_: Arguments<'_>) -> String {
    String::new()
}

/// Instead of `CString::new`: without a search for NULs that are not there.
#[unsafe(no_mangle)]
pub fn eightfold_c_string(text: &str) -> Result<CString, NulError> {
    // SAFETY: zero is a byte.
    let mut bytes = unsafe { Box::<[u8]>::new_zeroed_slice(text.len() + 1).assume_init() };
    bytes[..text.len()].copy_from_slice(text.as_bytes());
    // SAFETY: what asks for a `CString` in the intro is a title, which has no NUL.
    Ok(unsafe { Box::from_raw(Box::into_raw(bytes) as *mut CStr) }.into_c_string())
}

/// Instead of `CStr::from_bytes_with_nul`: no text. `minifb` makes characters of keys this way.
#[unsafe(no_mangle)]
pub fn eightfold_no_text(_: &[u8]) -> Result<&CStr, FromBytesWithNulError> {
    Err(FromBytesWithNulError::NotNulTerminated)
}

/// Instead of `CStr::to_str`, which that leads to.
#[unsafe(no_mangle)]
pub fn eightfold_to_str(_: &CStr) -> Result<&str, std::str::Utf8Error> {
    Ok("")
}

/// Instead of `Instant::now`: the time zero. `minifb` measures how long keys are held and frames take;
/// this crate has a [clock](crate::clock).
#[unsafe(no_mangle)]
pub fn eightfold_now() -> Instant {
    // SAFETY: it is made of seconds and nanoseconds, of which zero is a value.
    unsafe { core::mem::zeroed() }
}

/// Instead of `Instant::elapsed`: no time.
#[unsafe(no_mangle)]
pub fn eightfold_elapsed(_: &Instant) -> Duration {
    Duration::ZERO
}

/// Instead of `Instant::duration_since`: no time.
#[unsafe(no_mangle)]
pub fn eightfold_since(_: &Instant, _: Instant) -> Duration {
    Duration::ZERO
}
