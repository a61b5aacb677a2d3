//! Explanation of the rendering method: an overlay, and a picture that has not been refined to its end.

use super::fields::Range;
use super::validate::SHARE;

fields! {
    /// How brightly a frame shows the points that were traced, the squares that were filled, and the picture itself, 0 to 1 each;
    /// and how coarse the picture stays.
    pub struct Method in "" {
        /// Brightness of a white dot on every point that was traced.
        points: f32 = 0.0, in SHARE;
        /// Brightness of the outlines of the squares that were filled.
        squares: f32 = 0.0, in SHARE;
        /// Brightness of the picture itself; 1 leaves it as it is.
        picture: f32 = 1.0, in SHARE;
        /// The side in pixels up to which squares are filled with one colour, whatever their corners show: 0 to
        /// [`Quality::MAX_SQUARE`](crate::Quality::MAX_SQUARE); below 2 there are none. The largest squares are as large as these, and a
        /// coarse picture is not antialiased.
        coarse: f32 = 0.0, in SIDE;
        /// How far a front has come over the picture from the left, as a share of its width, 0 to 1. Behind it the picture is finished:
        /// at full brightness and antialiased, without marks. The front itself is a bright line.
        front: f32 = 0.0, in SHARE;
    }
}

/// The sides of squares, up to [`Quality::MAX_SQUARE`](crate::Quality::MAX_SQUARE).
const SIDE: Range = Range::new(0.0, 32.0, "0 to 32");

impl Method {
    /// The picture without an overlay.
    pub const PLAIN: Self = Self::STANDARD;
}
