use crate::{enlarge::MOST_SMALL, render_target::MOST_PIXELS, static_cell::StaticCell};

static PIXELS: StaticCell<[u32; MOST_PIXELS]> = StaticCell::new([0; _]);

static SMALL: StaticCell<[u32; MOST_SMALL]> = StaticCell::new([0; _]);

/// Returns zeroed memory for a small picture, once.
pub fn small() -> &'static mut [u32] {
    SMALL.take()
}

/// Returns zeroed memory for a frame, once.
pub fn pixels() -> &'static mut [u32] {
    PIXELS.take()
}
