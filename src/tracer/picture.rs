//! The picture: where it goes, and its parts, the bands of it that threads draw, and which blocks of these may have edges.

use crate::counts::Counts;
use crate::quality::Quality;
use crate::{MAX_HEIGHT, MAX_WIDTH};
use core::ops::Range;
use glam::{Vec2, vec2};

/// Where a picture goes, its size, and which points of it are looked at.
#[non_exhaustive]
pub struct Frame<'a> {
    /// Pixels in a row, 1 to [`MAX_WIDTH`].
    pub width: usize,
    /// Rows, 1 to [`MAX_HEIGHT`].
    pub height: usize,
    /// `0x00RRGGBB`, row after row from the top, each [`stride`](Self::stride) pixels after the one before. Those between and
    /// beyond stay as they are.
    pub pixels: &'a mut [u32],
    /// How many pixels a row begins after the one above it: `width`, unless [`Frame::with_stride`] says more.
    pub stride: usize,
    /// See [`Frame::with_offset`].
    pub offset: Vec2,
    /// See [`Frame::with_probes`].
    pub probing: Probing,
}

/// Which pixels of a frame are probed, see [`Frame::with_probes`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Probing {
    /// How many, unless they fall on what an overlay hides.
    pub count: u16,
    /// Which ones.
    pub seed: u32,
}

impl<'a> Frame<'a> {
    /// A number of probes for [`Frame::with_probes`] that takes less than 1 % of the time of a default frame of 1024x768: by AVX2,
    /// callgrind counts 0.8 % more instructions for the model scene, 0.6 and 0.3 % more for the show at 20 and at 76 s.
    pub const PROBES: u16 = 80;

    /// A frame of so many pixels in a row, and so many rows, in these pixels.
    /// [`Renderer::render`](crate::Renderer::render) says whether they fit.
    #[must_use]
    pub const fn new(width: usize, height: usize, pixels: &'a mut [u32]) -> Self {
        Self {
            width,
            height,
            pixels,
            stride: width,
            offset: Vec2::ZERO,
            probing: Probing { count: 0, seed: 0 },
        }
    }

    /// The same frame in a larger picture, or one with room between its rows: each begins so many pixels after the one above it,
    /// which is `width` or more.
    #[must_use]
    pub const fn with_stride(self, stride: usize) -> Self {
        Self { stride, ..self }
    }

    /// The same frame with its samples `x` pixels to the right of the pixels' centres and `y` below them, within -0.5 to 0.5. The
    /// mean of frames that cover a pixel evenly is a supersampled one.
    #[must_use]
    pub const fn with_offset(self, x: f32, y: f32) -> Self {
        Self {
            offset: vec2(x, y),
            ..self
        }
    }

    /// The same frame with so many of its pixels probed: [`Counts::probes`] then says how far they are off what they are if every
    /// pixel is traced. The picture stays as it is.
    ///
    /// The seed says which pixels. Frames whose seeds follow each other probe other pixels, until each pixel was probed once; so the number
    /// of the frame is a good seed. Neither an overlay that explains the method nor what is
    /// coarse on purpose is probed (see [`Method`](crate::scene::Method)): such a frame has no probes. What lies over the picture, such as
    /// captions, is drawn later.
    ///
    /// The estimate of the mean squared error has no bias. How certain it is, [`Probes::margin`](crate::Probes::margin) tells: few
    /// pixels make most of the error, so that one frame's is as good as none; at 60 frames a second those of a second are
    /// within one or two dB, and those of a minute within some tenths.
    #[must_use]
    pub const fn with_probes(self, count: u16, seed: u32) -> Self {
        Self {
            probing: Probing { count, seed },
            ..self
        }
    }
}

impl Frame<'_> {
    /// Returns the number of pixels from the first to the last one.
    pub(crate) fn count(&self) -> usize {
        let Some(above) = self.height.checked_sub(1) else {
            return 0;
        };
        let last_row = self.stride.saturating_mul(above);
        last_row.saturating_add(self.width)
    }

    /// Returns the surface that the frame is drawn on.
    pub(crate) fn surface<'a>(&'a mut self, rough: &'a mut [RoughRow]) -> Band<'a> {
        let count = self.count();
        Band {
            width: self.width,
            stride: self.stride,
            pixels: &mut self.pixels[..count],
            rough,
            ..Band::none()
        }
    }
}

/// The width of a tile in pixels. A row of a level's bits is then eight words, and the samples of its points stay in a core's own
/// cache.
pub(crate) const TILE_WIDTH: usize = 512;
/// The height of a tile and of a band in pixels: the side of the largest square. The picture's last band may have fewer rows.
pub(crate) const TILE_HEIGHT: usize = Quality::MAX_SQUARE;

/// Bands of the tallest picture.
pub(crate) const MAX_BANDS: usize = MAX_HEIGHT.div_ceil(TILE_HEIGHT);

/// The side of a block in pixels.
pub(crate) const BLOCK: usize = TILE_WIDTH / u64::BITS as usize;

/// How many rows of blocks a band has at most.
pub(crate) const BLOCK_ROWS: usize = TILE_HEIGHT / BLOCK;

/// A bit for each block of 8x8 pixels in a row of blocks, a word for each tile: whether it is rough, so that neighbouring pixels in
/// it may differ by an edge. In the others no two neighbours do, nor across the border of two that are not rough.
pub(crate) type RoughRow = [u64; MAX_WIDTH.div_ceil(TILE_WIDTH)];

/// The rows of blocks of all bands.
pub(crate) type Rough = [RoughRow; BLOCK_ROWS * MAX_BANDS];

/// Some rows of the picture, or all of them: the surface that is drawn on, and the unit of work that threads share.
pub struct Band<'a> {
    /// The picture's rows from here.
    pub(crate) top: usize,
    pub(crate) width: usize,
    /// How many pixels a row begins after the one above it.
    pub(crate) stride: usize,
    pub(crate) pixels: &'a mut [u32],
    /// How much work it was to draw it. The frame's counts are those of all its bands.
    pub counts: Counts,
    /// Which of its blocks are rough, row after row.
    pub(crate) rough: &'a mut [RoughRow],
}

impl Band<'_> {
    /// Which rows of the picture it has, counted from the top.
    #[must_use]
    pub fn rows_of_picture(&self) -> Range<usize> {
        self.top..self.top + self.height()
    }

    /// Has it count as drawn by somebody else, of whom nothing is known but the pixels that are in it when edges are antialiased: then
    /// the rows next to the bands that are drawn here have to be there.
    pub fn be_unknown(&mut self) {
        self.rough.fill([u64::MAX; _]);
    }

    /// How many rows it has.
    pub(crate) fn height(&self) -> usize {
        // The last row ends with its last pixel.
        (self.pixels.len() + self.stride - self.width) / self.stride
    }

    /// Its rows with their numbers, from its own top.
    pub(crate) fn rows(&mut self) -> impl Iterator<Item = (usize, &mut [u32])> {
        let rows = self.pixels.chunks_mut(self.stride.max(1));
        rows.map(|row| &mut row[..self.width]).enumerate()
    }

    /// Sets a pixel, if it is in the picture.
    #[inline(always)]
    pub(crate) fn put(&mut self, x: usize, y: usize, pixel: u32) {
        let place = self.pixels.get_mut(y * self.stride + x);
        if let (true, Some(place)) = (x < self.width, place) {
            *place = pixel;
        }
    }

    /// Divides it into bands of [`TILE_HEIGHT`] rows, from the top.
    pub(crate) fn parts(&mut self) -> impl ExactSizeIterator<Item = Band<'_>> {
        let &mut Self { width, stride, .. } = self;
        let pixels = self.pixels.chunks_mut(TILE_HEIGHT * stride);
        let parts = pixels.zip(self.rough.chunks_mut(BLOCK_ROWS)).enumerate();
        parts.map(move |(number, (pixels, rough))| Band {
            top: number * TILE_HEIGHT,
            width,
            stride,
            pixels,
            rough,
            ..Band::none()
        })
    }

    /// Returns a band without rows.
    pub(crate) const fn none() -> Self {
        Self {
            top: 0,
            width: 0,
            stride: 1,
            pixels: &mut [],
            counts: Counts::NONE,
            rough: &mut [],
        }
    }
}
