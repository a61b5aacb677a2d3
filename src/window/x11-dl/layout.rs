//! The sizes that Xlib's headers give on every 64-bit system.

use crate::types::*;

const _: () = {
    assert!(core::mem::offset_of!(Display, screens) == 232);
    assert!(size_of::<Screen>() == 128);
    assert!(size_of::<XEvent>() == 192);
    assert!(size_of::<XClientMessageEvent>() == 96);
    assert!(size_of::<XImage>() == 136);
    assert!(size_of::<XWindowAttributes>() == 136);
    assert!(size_of::<XSetWindowAttributes>() == 112);
    assert!(size_of::<XSizeHints>() == 80);
};
