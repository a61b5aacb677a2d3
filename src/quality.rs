//! Every dial that trades accuracy for speed.

/// How a frame is refined and how far its rays are followed.
///
/// Two frames of the same scene, time and size differ only by this.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// Side of the largest square in pixels, 1 to [`Quality::MAX_SQUARE`]. At 1 every pixel is traced.
    pub square: usize,
    /// Corners must agree in the objects hit by rays of at most this depth (the primary ray has depth 0).
    pub key_depth: u32,
    /// Corners must agree in the lights' states at hits of rays of at most this depth.
    pub state_depth: u32,
    /// A highlight `ks (r.v)^h` above this makes a lit light "lit with a highlight", a state of its own.
    pub highlight: f32,
    /// Rays of a depth above this are not followed, 0 to [`Quality::MAX_DEPTH`].
    pub depth: u32,
    /// A secondary ray is followed while the product of the coefficients along its path is at least this.
    pub least_contribution: f32,
}

impl Quality {
    /// The largest [`Quality::square`]: what the working memory has room for.
    pub const MAX_SQUARE: usize = 32;
    /// The largest [`Quality::depth`]: a ray's place in its tree is a number of 8 bits.
    pub const MAX_DEPTH: u32 = 7;

    /// Every pixel is traced: the oracle that the other qualities are measured against.
    pub const EXHAUSTIVE: Self = Self {
        square: 1,
        key_depth: 5,
        state_depth: 0,
        highlight: 1.0 / 256.0,
        depth: 5,
        least_contribution: 0.01,
    };

    /// The rules of 2008: squares of 8 pixels, the objects of the whole ray tree, the lights at the primary hit.
    pub const THESIS: Self = Self {
        square: 8,
        ..Self::EXHAUSTIVE
    };
}
