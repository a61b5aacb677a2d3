//! The state of a search through a level's squares.

use super::squares::Squares;
use crate::grid::Bits;
use crate::picture::TILE_HEIGHT;

pub(super) const ALL: u64 = 0b1111;

pub(super) const SQUARE_ROWS: usize = TILE_HEIGHT / 2;

/// The squares of a row in three sets, by how many of their corners the shadows from one light, or
/// the images, cover.
///
/// A convex outline around all corners covers the square. Two outlines that each cover some corners
/// may leave a slit between them, so the square is opened.
#[derive(Clone, Copy)]
pub(super) struct Covered {
    /// One outline covers all corners.
    pub wholly: Bits,
    /// One outline covers some corners that show the plane.
    pub partly: Bits,
    /// Too few corners show a shadow, or two outlines each cover some corners.
    pub missed: Bits,
}

impl Covered {
    pub const NONE: Self = Self { wholly: Bits::NONE, partly: Bits::NONE, missed: Bits::NONE };
}

pub(super) struct Search<'a> {
    pub squares: &'a Squares<'a>,
    pub open: [Bits; TILE_HEIGHT],
    pub light: Option<u8>,
    /// The mask of corners that show the feature must be at least this, or the square is opened: 1
    /// (any corner), or [`ALL`] for a thin outline.
    pub enough: u64,
    /// For each row, the squares that shadows from `light` cover; without a light, those that
    /// images cover.
    pub covered: [Covered; SQUARE_ROWS],
}
