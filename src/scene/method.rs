//! What explains the rendering method: an overlay, and a picture that has not been refined to its end.

use crate::quality::Quality;

/// How brightly a frame shows the points that were traced, the squares that were filled, and the picture itself, 0 to 1 each;
/// and how coarse the picture stays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Method {
    /// Brightness of a white dot on every point that was traced.
    pub points: f32,
    /// Brightness of the outlines of the squares that were filled.
    pub squares: f32,
    /// Brightness of the picture itself; 1 leaves it as it is.
    pub picture: f32,
    /// The side in pixels up to which squares are filled with one colour, whatever their corners show: 0 to
    /// [`Quality::MAX_SQUARE`]; below 2 there are none.
    pub coarse: f32,
    /// How far a front has come over the picture from the left, as a share of its width, 0 to 1. Behind it the picture is finished:
    /// at full brightness and antialiased, without marks. The front itself is a bright line.
    pub front: f32,
}

impl Method {
    /// The picture without an overlay.
    pub const PLAIN: Self = Self {
        points: 0.0,
        squares: 0.0,
        picture: 1.0,
        coarse: 0.0,
        front: 0.0,
    };

    /// A quality whose largest squares are as large as the coarse ones. A coarse picture is not antialiased: its squares have edges.
    pub(crate) fn coarsened(&self, quality: &Quality) -> Quality {
        let mut quality = *quality;
        if self.coarse >= 2.0 {
            quality.antialias = false;
            quality.square = quality
                .square
                .max(1 << (self.coarse as usize).min(Quality::MAX_SQUARE).ilog2());
        }
        quality
    }
}

impl Default for Method {
    /// [`Method::PLAIN`].
    fn default() -> Self {
        Self::PLAIN
    }
}
