//! The sizes that Xlib's headers give on every 64-bit system.

use super::types::*;

const _: () = {
    assert!(size_of::<Screen>() == 128);
    assert!(size_of::<XEvent>() == 192);
    assert!(size_of::<XClientMessageEvent>() == 96);
    assert!(size_of::<XImage>() == 136);
    assert!(size_of::<XWindowAttributes>() == 136);
};
