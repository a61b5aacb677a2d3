use crate::{enlarge::MAX_SMALL, render_target::MAX_PIXELS, static_cell::StaticCell};

static PIXELS: StaticCell<[u32; MAX_PIXELS]> = StaticCell::new([0; _]);

static SMALL: StaticCell<[u32; MAX_SMALL]> = StaticCell::new([0; _]);

pub fn small() -> &'static mut [u32] {
    SMALL.take()
}

pub fn pixels() -> &'static mut [u32] {
    PIXELS.take()
}
