//! Bits for the squares and points of a tile.

use super::bits::Bits;
use super::pyramid::LEVELS;
use crate::picture::{BLOCK_ROWS, TILE_HEIGHT};

/// Points are traced cluster by cluster: rays of neighbours meet the same objects. A cluster is as many points wide.
pub(super) const CLUSTER_WIDTH: usize = 4;
/// Rows of a cluster: its points are the bits of a word. (Clusters of 8x8 points take the show 6 % longer.)
pub(super) const CLUSTER_HEIGHT: usize = 64 / CLUSTER_WIDTH;

/// The squares and points of a tile that matter, a row of bits for each row of a level's.
pub(super) struct Marks {
    /// Squares that are looked at: all of the largest, then the parts of those that were split.
    pub squares: [[Bits; TILE_HEIGHT]; LEVELS],
    /// Those of them that may show something which their corners do not; before the guard has looked at them, the parts of
    /// such ones.
    pub open: [[Bits; TILE_HEIGHT]; LEVELS],
    /// Those that were filled: no pixels, so there are half as many rows at most.
    pub filled: [[Bits; TILE_HEIGHT / 2]; LEVELS],
    /// Those of squares of 8, if these are the largest, that were filled by colours between their corners'.
    pub smooth: [u64; BLOCK_ROWS],
    /// Points that were traced; clusters of them end with more rows than there are.
    pub traced: [[Bits; TILE_HEIGHT + CLUSTER_HEIGHT]; LEVELS],
}

impl Marks {
    pub const fn new() -> Self {
        Self {
            squares: [[Bits::NONE; TILE_HEIGHT]; LEVELS],
            open: [[Bits::NONE; TILE_HEIGHT]; LEVELS],
            filled: [[Bits::NONE; TILE_HEIGHT / 2]; LEVELS],
            smooth: [0; BLOCK_ROWS],
            traced: [[Bits::NONE; TILE_HEIGHT + CLUSTER_HEIGHT]; LEVELS],
        }
    }
}
