use crate::backend::memory::pixels;

/// The largest frame, in pixels.
pub const MAX_WIDTH: usize = 3840;
/// In pixels.
pub const MAX_HEIGHT: usize = 2160;
pub const MAX_PIXELS: usize = MAX_WIDTH * MAX_HEIGHT;

/// The inner size of a new window, in pixels.
#[derive(Clone, Copy, Debug)]
pub enum InnerSize {
    Exactly(usize, usize),
    /// Smaller on a small monitor, with the same aspect ratio; `minifb` does not know the monitor.
    AtMost(usize, usize),
}

impl InnerSize {
    /// Returns width and height, and whether the window may be smaller.
    #[inline(always)]
    pub(crate) fn parts(self) -> ((usize, usize), bool) {
        match self {
            Self::Exactly(width, height) => ((width, height), false),
            Self::AtMost(width, height) => ((width, height), true),
        }
    }
}

/// A target for frames: [`Window`](crate::window::Window), [`Terminal`](crate::terminal::Terminal)
/// or [`Headless`].
pub trait RenderTarget {
    /// Returns the target's width and height in pixels, at least 1. For more than [`MAX_PIXELS`],
    /// draw a smaller frame: it is stretched.
    fn size(&self) -> (usize, usize);

    /// Returns the pixels of the next frame, `width` by `height`, `0x00RRGGBB`, row by row, with
    /// undefined content.
    ///
    /// # Panics
    /// If `width * height` is above [`MAX_PIXELS`].
    fn canvas(&mut self, width: usize, height: usize) -> &mut [u32];

    fn show(&mut self) -> Next;
}

impl Next {
    pub(crate) fn toggled(self) -> Next {
        match self {
            Next::GoOn => Next::Toggle,
            _ => Next::GoOn,
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Next {
    GoOn,
    /// The show continues, and H toggles the numbers over the picture.
    Toggle,
    /// The show ends with this exit code: 0 if the viewer ended it, otherwise 1 or more.
    End(i32),
}

pub struct Headless {
    size: (usize, usize),
    pixels: &'static mut [u32],
}

impl Headless {
    #[must_use]
    pub fn new(size: (usize, usize)) -> Headless {
        Headless { size, pixels: pixels() }
    }
}

impl RenderTarget for Headless {
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

/// Returns the target's size, or the largest size within `max` of its aspect ratio. No side is 0.
pub fn fit((width, height): (usize, usize), max: (usize, usize)) -> (usize, usize) {
    if width <= max.0 && height <= max.1 {
        (width.max(1), height.max(1))
    } else if width * max.1 > height * max.0 {
        (max.0, (height * max.0 / width).max(1))
    } else {
        ((width * max.1 / height).max(1), max.1)
    }
}
