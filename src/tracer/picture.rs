//! The picture in parts: where it goes, the bands of it that threads draw, and which blocks of these may have edges.

use crate::counts::Counts;
use crate::{MAX_HEIGHT, MAX_WIDTH};

/// The largest width of a tile in pixels; it has as many whole squares as fit. A row of a level's bits is then eight words, and the
/// samples of its points stay in a core's own cache.
pub(crate) const TILE_WIDTH: usize = 512;
/// The height of the tallest tile in pixels: that of the largest square.
pub(crate) const TILE_HEIGHT: usize = 32;

/// Bands of the tallest picture.
pub(crate) const MAX_BANDS: usize = MAX_HEIGHT.div_ceil(FEWEST_ROWS);

/// Rows of the lowest band: of one square whose side is more than half the tallest tile.
const FEWEST_ROWS: usize = TILE_HEIGHT / 2 + 1;

/// The side of a block in pixels.
pub(crate) const BLOCK: usize = TILE_WIDTH / u64::BITS as usize;

/// How many rows of blocks a band has at most.
pub(crate) const BLOCK_ROWS: usize = TILE_HEIGHT / BLOCK;

/// A bit for each block of 8x8 pixels in a row of blocks, a word for each tile: whether it is rough, so that neighbouring pixels in
/// it may differ by an edge. In the others no two neighbours do, nor across the border of two that are not rough.
pub(crate) type RoughRow = [u64; MAX_WIDTH.div_ceil(TILE_WIDTH)];

/// The rows of blocks of a band.
pub(crate) type Rough = [RoughRow; BLOCK_ROWS];

/// Some rows of the picture: the unit of work that threads share.
pub struct Band<'a> {
    /// The picture's rows from here.
    pub(crate) top: usize,
    pub(crate) width: usize,
    pub(crate) pixels: &'a mut [u32],
    /// How much work it was to draw it.
    pub(crate) counts: Counts,
    /// Which of its blocks are rough, row after row.
    pub(crate) rough: &'a mut [RoughRow],
}

impl Band<'_> {
    /// How many rows it has.
    pub(crate) fn height(&self) -> usize {
        self.pixels.len() / self.width
    }

    /// No rows.
    pub(crate) const fn none() -> Self {
        Self {
            top: 0,
            width: 0,
            pixels: &mut [],
            counts: Counts::NONE,
            rough: &mut [],
        }
    }
}

/// A picture that is drawn band by band.
pub(crate) struct Picture<'a> {
    pub width: usize,
    pub pixels: &'a mut [u32],
    /// Rows of a band; the last one may have fewer.
    pub rows: usize,
    /// Of each band, which of its blocks are rough.
    pub rough: &'a mut [Rough; MAX_BANDS],
}

impl Picture<'_> {
    /// Its bands, from the top.
    pub fn bands(&mut self) -> impl ExactSizeIterator<Item = Band<'_>> {
        let &mut Self { width, rows, .. } = self;
        let parts = self.pixels.chunks_mut(rows * width).zip(&mut *self.rough);
        parts
            .enumerate()
            .map(move |(number, (pixels, rough))| Band {
                top: number * rows,
                width,
                pixels,
                rough,
                ..Band::none()
            })
    }
}
