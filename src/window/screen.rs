//! What frames are shown on.

use std::{
    alloc::{Layout, alloc_zeroed, handle_alloc_error},
    ptr::slice_from_raw_parts_mut,
};

/// The most pixels that a frame may have: 3840x2160.
pub const MOST_PIXELS: usize = 3840 * 2160;

/// Memory for so many pixels, zero to begin with; it is taken from the system where it is written to.
pub(crate) fn pixels(count: usize) -> Box<[u32]> {
    assert!(count <= 2 * MOST_PIXELS);
    // SAFETY: the size is far from too large; the memory is as large as the slice, and zero is a pixel.
    unsafe {
        let layout = Layout::from_size_align_unchecked(4 * count, 4);
        let memory = alloc_zeroed(layout);
        if memory.is_null() {
            handle_alloc_error(layout);
        }
        Box::from_raw(slice_from_raw_parts_mut(memory.cast(), count))
    }
}

/// A place for frames: [`Window`](crate::window::Window), [`Terminal`](crate::terminal::Terminal) or
/// [`Unseen`].
pub trait Screen {
    /// Width and height in pixels that the next frame should have, at least 1. There may be more than
    /// [`MOST_PIXELS`]; then the frame has to be smaller, and is stretched.
    fn size(&self) -> (usize, usize);

    /// Where to draw the next frame, of `width` by `height` pixels, `0x00RRGGBB`, row after row. What
    /// is there already is of no use.
    ///
    /// # Panics
    /// If these are more than [`MOST_PIXELS`].
    fn canvas(&mut self, width: usize, height: usize) -> &mut [u32];

    /// Shows the frame, and looks at what the viewer has done meanwhile.
    fn show(&mut self) -> Next;
}

/// Whether the show goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Next {
    /// It goes on.
    GoOn,
    /// It ends, with this exit code: 0 if the viewer ended it, something else if the screen was lost.
    End(i32),
}

/// No screen: the frames are drawn and not shown.
pub struct Unseen {
    size: (usize, usize),
    pixels: Box<[u32]>,
}

impl Unseen {
    /// As if there were a window of a size in pixels.
    #[must_use]
    pub fn new(width: usize, height: usize) -> Unseen {
        Unseen {
            size: (width, height),
            pixels: pixels(MOST_PIXELS),
        }
    }
}

impl Screen for Unseen {
    fn size(&self) -> (usize, usize) {
        self.size
    }

    fn canvas(&mut self, width: usize, height: usize) -> &mut [u32] {
        &mut self.pixels[..width * height]
    }

    fn show(&mut self) -> Next {
        Next::GoOn
    }
}
