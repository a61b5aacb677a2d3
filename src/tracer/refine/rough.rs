//! Which parts of a picture may have edges, as drawing it tells: antialiasing looks at no others.

use super::{TILE_HEIGHT, TILE_WIDTH};
use crate::MAX_WIDTH;

/// The least difference of neighbours, in a channel and 255ths, that is an edge.
pub(super) const EDGE: u8 = 20;

/// A bit for each block of 8x8 pixels in a row of blocks, a word for each tile: whether it is rough, so that neighbouring pixels in
/// it may differ by an edge. In the others no two neighbours do, nor across the border of two that are not rough.
pub(super) type RoughRow = [u64; MAX_WIDTH.div_ceil(TILE_WIDTH)];

/// The rows of blocks of a band.
pub(crate) type Rough = [RoughRow; BLOCK_ROWS];

/// How many rows of blocks a band has at most.
pub(super) const BLOCK_ROWS: usize = TILE_HEIGHT / BLOCK;

/// The side of a block in pixels.
pub(super) const BLOCK: usize = TILE_WIDTH / u64::BITS as usize;
