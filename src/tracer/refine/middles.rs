//! The points between pixels that antialiasing traces, summed up by the pixels beside them.

use crate::picture::TILE_HEIGHT;

/// Pixels of a stretch of a band along x, whose rays meet the same groups: as many as a word has marks.
pub(super) const STRETCH: usize = u64::BITS as usize;

/// For each pixel of a stretch, the sum of the points beside it: blue, green and red from the low bits up, in 128ths of an output
/// step. All are 0 in between.
pub(super) type Middles = [[u64; STRETCH]; TILE_HEIGHT];

/// No sums.
pub(super) const NO_MIDDLES: Middles = [[0; STRETCH]; TILE_HEIGHT];
