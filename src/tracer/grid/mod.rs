//! The grids of a tile: its squares and their corners, level by level.
//!
//! Level `n` has squares of `1 << n` pixels a side; level 0 has pixels. `area` is the rectangle of the picture that the grids
//! cover, `bits` has a bit for each square or point of a row, and `pyramid` the samples of all points.

mod area;
mod bits;
mod pyramid;

pub(crate) use area::Area;
pub(crate) use bits::{Bits, WORDS};
pub(crate) use pyramid::{GridRow, LEVELS, Pyramid};
