//! The overlay that explains the rendering method.

/// How brightly a frame shows the points that were traced, the squares that were filled, and the picture itself; 0 to 1 each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Method {
    /// Brightness of a white dot on every point that was traced.
    pub points: f32,
    /// Brightness of the outlines of the squares that were filled.
    pub squares: f32,
    /// Brightness of the picture itself; 1 leaves it as it is.
    pub picture: f32,
}

impl Method {
    /// The picture without an overlay.
    pub const PLAIN: Self = Self {
        points: 0.0,
        squares: 0.0,
        picture: 1.0,
    };
}

impl Default for Method {
    /// [`Method::PLAIN`].
    fn default() -> Self {
        Self::PLAIN
    }
}
