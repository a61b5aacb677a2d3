use crate::{render_target::MOST_PIXELS, static_cell::StaticCell};

static PIXELS: StaticCell<[u32; MOST_PIXELS]> = StaticCell::new([0; _]);

/// Returns zeroed memory for a frame, once.
pub fn pixels() -> &'static mut [u32] {
    PIXELS.take()
}
