//! The replacement for std's panic functions in the intro, see `src/pack/build/redirect.rs`. Other
//! programs do not call it. Only bugs panic, never errors.

use crate::{line, terminal};

/// Restores the terminal, prints one line on standard error and aborts.
#[unsafe(no_mangle)]
pub extern "C" fn eightfold_abort() -> ! {
    terminal::restore();
    line::write(line::ERROR, b"eightfold: internal error\n");
    #[cfg(feature = "windows")]
    super::arguments::end(3);
    // SAFETY: it may be called at any time.
    #[cfg(not(feature = "windows"))]
    unsafe {
        libc::abort()
    }
}
