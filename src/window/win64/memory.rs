//! Memory for frames, which the program has from the start, and Windows gives where it is written to.

use crate::{fixed::Fixed, screen::MOST_PIXELS};

static PIXELS: Fixed<[u32; MOST_PIXELS]> = Fixed::new([0; _]);

/// Memory for a frame, zero to begin with. It can be had once.
pub fn pixels() -> &'static mut [u32] {
    PIXELS.take()
}
