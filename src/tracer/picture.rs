//! Frames, and the bands that threads draw.

use crate::counts::Counts;
use crate::quality::Quality;
use crate::scene::Presentation;
use core::ops::Range;
use glam::{Vec2, vec2};

/// The maximum width of a picture, in pixels.
pub const MAX_WIDTH: usize = 3840;
/// The maximum height of a picture, in pixels.
pub const MAX_HEIGHT: usize = 2160;

/// The destination of a picture.
#[non_exhaustive]
pub struct Frame<'a> {
    /// Pixels in a row, 1 to [`MAX_WIDTH`].
    pub width: usize,
    /// Rows, 1 to [`MAX_HEIGHT`].
    pub height: usize,
    /// `0x00RRGGBB`, row by row from the top. Pixels outside the rows stay unchanged.
    pub pixels: &'a mut [u32],
    /// The distance between the starts of two rows in pixels, at least `width`.
    pub stride: usize,
    /// See [`Frame::with_offset`].
    pub offset: Vec2,
    /// See [`Frame::with_probes`].
    pub probing: Probing,
    /// See [`Frame::with_presentation`].
    pub presentation: &'a Presentation,
}

/// The probed pixels, see [`Frame::with_probes`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Probing {
    /// The number of probed pixels in each frame.
    pub count: u16,
    /// Selects the pixels.
    pub seed: u32,
}

impl<'a> Frame<'a> {
    /// The number of probes that take less than 1 % of a default frame of 1024x768 (0.8 % of the model scene's instructions, AVX2).
    pub const PROBES: u16 = 80;

    /// Returns a frame without gaps between rows. [`Renderer::render`](crate::Renderer::render) checks the sizes.
    #[must_use]
    pub const fn new(width: usize, height: usize, pixels: &'a mut [u32]) -> Self {
        Self {
            width,
            height,
            pixels,
            stride: width,
            offset: Vec2::ZERO,
            probing: Probing { count: 0, seed: 0 },
            presentation: &Presentation::PLAIN,
        }
    }

    /// Sets the [stride](Frame::stride), to draw into a larger picture or into padded rows.
    #[must_use]
    pub const fn with_stride(self, stride: usize) -> Self {
        Self { stride, ..self }
    }

    /// Moves samples `x` pixels right and `y` down, -0.5 to 0.5 each. For supersampling, average frames whose offsets cover a pixel
    /// evenly.
    #[must_use]
    pub const fn with_offset(self, x: f32, y: f32) -> Self {
        Self { offset: vec2(x, y), ..self }
    }

    /// Traces `count` pixels as [`Quality::reference`] does, and compares them with the frame, which stays unchanged. The results are in
    /// [`Counts::probes`].
    ///
    /// Pass the frame's number as the seed: consecutive seeds probe different pixels until each was probed once. Probes ignore captions,
    /// and pixels with a [`Method`](crate::scene::Method) overlay or coarse squares.
    ///
    /// The estimated mean squared error is unbiased. A few pixels have most of it, so add the probes of many frames: at 60 frames a
    /// second it is accurate to 2 dB after a second, and to some tenths of a dB after a minute.
    #[must_use]
    pub const fn with_probes(self, count: u16, seed: u32) -> Self {
        Self { probing: Probing { count, seed }, ..self }
    }

    /// Sets the presentation, [`Presentation::PLAIN`] by default.
    #[must_use]
    pub const fn with_presentation(self, presentation: &'a Presentation) -> Self {
        Self { presentation, ..self }
    }
}

impl Frame<'_> {
    pub(crate) fn count(&self) -> usize {
        let Some(above) = self.height.checked_sub(1) else {
            return 0;
        };
        let last_row = self.stride.saturating_mul(above);
        last_row.saturating_add(self.width)
    }

    pub(crate) fn band<'a>(&'a mut self, rough: &'a mut [RoughRow]) -> Band<'a> {
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

/// A row of bits is eight words, and a tile's samples fit in the core's own cache.
pub(crate) const TILE_WIDTH: usize = 512;
/// The side of the largest square. The last band may be lower.
pub(crate) const TILE_HEIGHT: usize = Quality::MAX_SQUARE;

pub(crate) const MAX_BANDS: usize = MAX_HEIGHT.div_ceil(TILE_HEIGHT);

pub(crate) const CELL: usize = TILE_WIDTH / u64::BITS as usize;

pub(crate) const CELL_ROWS: usize = TILE_HEIGHT / CELL;

/// One bit per cell of 8x8 pixels, one word per tile: set if the cell is rough. Neighbouring pixels of smooth cells never form an edge.
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

    /// Marks the band as drawn by the caller, with edges anywhere. Draw it next to the renderer's bands before these are antialiased.
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
