//! Callbacks for statistics and visualisation.

use crate::counts::Counts;

/// Receives a frame's points and squares, from all threads concurrently and in any order. For `()`
/// the compiler removes all calls.
///
/// Coordinates are in pixels. Points may be up to one square's side beyond the right and the lower
/// edge of the picture.
pub trait Observer: Copy + Sync {
    /// Whether the methods are called.
    const LISTENS: bool = true;

    /// Called for each traced point with its work.
    fn point(self, _x: usize, _y: usize, _work: Counts) {}

    /// Called for each drawn square of `w` by `h` pixels with its upper left pixel.
    fn square(self, _x: usize, _y: usize, _w: usize, _h: usize, _fill: Fill) {}

    /// Called for each split square of `side` pixels with its upper left pixel, before the square's
    /// parts.
    fn split(self, _x: usize, _y: usize, _side: usize, _why: Split) {}
}

/// The reason to split a square.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Split {
    /// It may show a feature that its corners do not, see
    /// [`Quality::guarded`](crate::Quality::guarded).
    Uncovered,
    /// Its corners show several objects, or their keys differ and their colours exceed
    /// [`tolerance_differing`](crate::Quality::tolerance_differing).
    Keys,
    /// Its corners have equal keys, and colours beyond
    /// [`tolerance_agreeing`](crate::Quality::tolerance_agreeing).
    Colours,
    /// It could be filled, but is between two squares that were split for their corners.
    Gap,
}

/// The source of a square's pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Fill {
    /// All pixels have one colour.
    Flat,
    /// Colours are interpolated between the corners.
    Bilinear,
    /// Light is interpolated between the corners, and the pattern evaluated at each pixel.
    Patterned,
    /// Each pixel has its own traced or averaged point.
    Points,
}

impl Observer for () {
    const LISTENS: bool = false;
}
