//! What happens to a frame's points and squares, told to whoever wants to draw or count it.
//!
//! The refiner is generic over who listens. The intro's listener is `()`, of which nothing is left when it is compiled.

use crate::trace::Counts;

/// Listens to how a frame comes about, from all threads at once and in no particular order.
///
/// Places are in pixels from the upper left; points may lie a square's side beyond the picture to the right and below.
pub trait Observer: Copy + Sync {
    /// Whether it is told anything.
    const LISTENS: bool = true;

    /// The point at (x, y) was traced. What is counted is that point's work alone.
    fn point(self, x: usize, y: usize, work: Counts);

    /// The square of `w` by `h` pixels at (x, y) was drawn.
    fn square(self, x: usize, y: usize, w: usize, h: usize, fill: Fill);
}

/// How a square got its pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fill {
    /// One colour.
    Flat,
    /// Colours between those of its corners.
    Bilinear,
    /// Light between that of its corners, and a pattern at each pixel.
    Patterned,
    /// Each pixel has a point of its own.
    Points,
}

impl Observer for () {
    const LISTENS: bool = false;

    #[inline(always)]
    fn point(self, _: usize, _: usize, _: Counts) {}

    #[inline(always)]
    fn square(self, _: usize, _: usize, _: usize, _: usize, _: Fill) {}
}
