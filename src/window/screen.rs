//! The screen that frames are shown on.

use crate::backend::memory::pixels;

/// The most pixels that a frame may have: 3840x2160.
pub const MOST_PIXELS: usize = 3840 * 2160;

/// A place for frames: [`Window`](crate::window::Window), [`Terminal`](crate::terminal::Terminal) or
/// [`Headless`].
pub trait Screen {
    /// Width and height in pixels that the next frame should have, at least 1. There may be more than
    /// [`MOST_PIXELS`]; then the frame has to be smaller, and is stretched.
    fn size(&self) -> (usize, usize);

    /// Where to draw the next frame, of `width` by `height` pixels, `0x00RRGGBB`, row after row. What is there already is
    /// of no use.
    ///
    /// # Panics
    /// If these are more than [`MOST_PIXELS`].
    fn canvas(&mut self, width: usize, height: usize) -> &mut [u32];

    /// Shows the frame, and looks at what the viewer has done meanwhile.
    fn show(&mut self) -> Next;
}

impl Next {
    /// The next step if H was pressed as well.
    pub(crate) fn toggled(self) -> Next {
        match self {
            Next::GoOn => Next::Toggle,
            _ => Next::GoOn,
        }
    }
}

/// Whether the show goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Next {
    /// It goes on.
    GoOn,
    /// It goes on, and H was pressed: the numbers over the picture come or go.
    Toggle,
    /// It ends, with this exit code: 0 if the viewer ended it, something else if the screen was lost.
    End(i32),
}

/// No screen: the frames are drawn and not shown.
pub struct Headless {
    size: (usize, usize),
    pixels: &'static mut [u32],
}

impl Headless {
    /// As if there were a window of a size in pixels.
    #[must_use]
    pub fn new(width: usize, height: usize) -> Headless {
        Headless {
            size: (width, height),
            pixels: pixels(),
        }
    }
}

impl Screen for Headless {
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

/// Returns the size of the picture for a screen of a given size: the same, or the largest of the same aspect ratio that is within `most`.
/// No side is 0.
#[inline]
pub fn fit((width, height): (usize, usize), most: (usize, usize)) -> (usize, usize) {
    if width <= most.0 && height <= most.1 {
        (width.max(1), height.max(1))
    } else if width * most.1 > height * most.0 {
        (most.0, (height * most.0 / width).max(1))
    } else {
        ((width * most.1 / height).max(1), most.1)
    }
}
