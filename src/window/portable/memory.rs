//! Memory for frames, from the system.

use crate::screen::MOST_PIXELS;

/// Memory for two frames, zero to begin with, which the system gives where it is written to. Ends the process where there is
/// none left.
pub fn pixels() -> &'static mut [u32] {
    vec![0; 2 * MOST_PIXELS].leak()
}
