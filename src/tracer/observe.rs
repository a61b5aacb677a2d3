//! Reports which points of a frame are traced and how its squares are filled, to draw or count them.
//!
//! The refiner is generic over the observer. For the intro's observer, `()`, the compiler removes all calls.

use crate::counts::Counts;

/// Is told about the points and squares of a frame, by all threads concurrently and in no particular order.
///
/// Coordinates are pixels of the picture, from its upper left. Points may lie up to one square's side beyond the right and the
/// lower edge of the picture.
pub trait Observer: Copy + Sync {
    /// Whether the methods are called at all.
    const LISTENS: bool = true;

    /// The point at (x, y) was traced; `work` counts this point alone.
    fn point(self, _x: usize, _y: usize, _work: Counts) {}

    /// The square of `w` by `h` pixels with its upper left at (x, y) was drawn.
    fn square(self, _x: usize, _y: usize, _w: usize, _h: usize, _fill: Fill) {}

    /// The square of so many pixels a side with its upper left at (x, y) was not filled: its parts follow.
    fn split(self, _x: usize, _y: usize, _side: usize, _why: Split) {}
}

/// Why a square was not filled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Split {
    /// Something may be seen in it that none of its corners shows (see [`Quality::guarded`](crate::Quality::guarded)).
    Uncovered,
    /// Its corners show different objects, or different light, in colours that are too far apart for that.
    Keys,
    /// Its corners show the same objects in the same light, in colours that are too far apart all the same.
    Colours,
}

/// How the pixels of a square were computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fill {
    /// All have the same colour.
    Flat,
    /// Colours are interpolated between the corners.
    Bilinear,
    /// The light is interpolated between the corners, and the pattern is evaluated at each pixel.
    Patterned,
    /// Each pixel has its own traced or averaged point.
    Points,
}

impl Observer for () {
    const LISTENS: bool = false;
}
