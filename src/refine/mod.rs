//! Which points of a band of the picture are traced, and what becomes of the rest.
//!
//! A band is some rows of squares. Its points are refined breadth-first, a stretch of the band at a time: the corners
//! of all squares are traced, then each square is filled or split, then the points that the splits asked for are
//! traced, and so on down to single pixels, so that lanes stay full. No point is traced twice: a stretch finds what the
//! one before it traced at their seam, and bands exchange the rows they share (see [`Border`]).

pub(crate) mod band;
mod fill;
mod points;
mod square;

pub use band::Band;
pub(crate) use band::render;
#[cfg(feature = "lab")]
pub(crate) use band::render_observed;
pub(crate) use points::{Border, Points};
pub(crate) use square::Square;
