use crate::counts::Counts;
use crate::quality::Quality;
use core::ops::Range;

/// The maximum width of a picture, in pixels.
pub const MAX_WIDTH: usize = 3840;
/// The maximum height of a picture, in pixels.
pub const MAX_HEIGHT: usize = 2160;

/// A row of bits is eight words, and a tile's samples fit in the core's own cache.
pub(crate) const TILE_WIDTH: usize = 512;
/// The side of the largest square. The last band may be lower.
pub(crate) const TILE_HEIGHT: usize = Quality::MAX_SQUARE;

pub(crate) const MAX_BANDS: usize = MAX_HEIGHT.div_ceil(TILE_HEIGHT);

pub(crate) const CELL: usize = TILE_WIDTH / u64::BITS as usize;

pub(crate) const CELL_ROWS: usize = TILE_HEIGHT / CELL;

/// One bit per cell of 8x8 pixels, one word per tile: set if the cell is rough. Neighbouring pixels
/// of smooth cells never form an edge.
pub(crate) type RoughRow = [u64; MAX_WIDTH.div_ceil(TILE_WIDTH)];

pub(crate) type Rough = [RoughRow; CELL_ROWS * MAX_BANDS];

/// Some rows of a picture: a thread's unit of work.
pub struct Band<'a> {
    pub(crate) top: usize,
    pub(crate) width: usize,
    pub(crate) stride: usize,
    pub(crate) pixels: &'a mut [u32],
    /// The work of drawing the band.
    pub counts: Counts,
    pub(crate) rough: &'a mut [RoughRow],
}

impl Band<'_> {
    /// Returns the range of the band's rows in the picture.
    #[must_use]
    pub fn rows_of_picture(&self) -> Range<usize> {
        self.top..self.top + self.height()
    }

    /// Marks the band as drawn by the caller, with edges anywhere. Draw it next to the renderer's
    /// bands before these are antialiased.
    #[doc(hidden)]
    pub fn mark_external(&mut self) {
        self.rough.fill([u64::MAX; _]);
    }

    pub(crate) fn height(&self) -> usize {
        (self.pixels.len() + self.stride - self.width) / self.stride
    }

    pub(crate) fn rows(&mut self) -> impl Iterator<Item = (usize, &mut [u32])> {
        let rows = self.pixels.chunks_mut(self.stride.max(1));
        rows.map(|row| &mut row[..self.width]).enumerate()
    }

    /// Sets a pixel, unless it is outside the band.
    #[inline(always)]
    pub(crate) fn put(&mut self, x: usize, y: usize, pixel: u32) {
        let place = self.pixels.get_mut(y * self.stride + x);
        if let (true, Some(place)) = (x < self.width, place) {
            *place = pixel;
        }
    }

    pub(crate) fn parts(&mut self) -> impl ExactSizeIterator<Item = Band<'_>> {
        let &mut Self { width, stride, .. } = self;
        let pixels = self.pixels.chunks_mut(TILE_HEIGHT * stride);
        let parts = pixels.zip(self.rough.chunks_mut(CELL_ROWS)).enumerate();
        parts.map(move |(number, (pixels, rough))| Band {
            top: number * TILE_HEIGHT,
            width,
            stride,
            pixels,
            rough,
            ..Band::none()
        })
    }

    pub(crate) const fn none() -> Self {
        Self { top: 0, width: 0, stride: 1, pixels: &mut [], counts: Counts::NONE, rough: &mut [] }
    }
}
