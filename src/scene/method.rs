//! The method, made visible.

/// How bright a picture shows its own making, 0 to 1 each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Method {
    /// Marks on the points that were traced.
    pub points: f32,
    /// Outlines of the squares that were filled.
    pub squares: f32,
    /// The picture itself.
    pub picture: f32,
}

impl Method {
    /// The plain picture.
    pub const PLAIN: Self = Self {
        points: 0.0,
        squares: 0.0,
        picture: 1.0,
    };
}

impl Default for Method {
    /// The plain picture.
    fn default() -> Self {
        Self::PLAIN
    }
}
