use crate::{enlarge::MOST_SMALL, render_target::MOST_PIXELS, static_cell::StaticCell};

static PIXELS: StaticCell<[u32; MOST_PIXELS]> = StaticCell::new([0; _]);

static SMALL: StaticCell<[u32; MOST_SMALL]> = StaticCell::new([0; _]);

pub fn small() -> &'static mut [u32] {
    SMALL.take()
}

pub fn pixels() -> &'static mut [u32] {
    PIXELS.take()
}
