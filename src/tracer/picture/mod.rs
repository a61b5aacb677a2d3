//! Frames, and the bands that threads draw.

mod band;
mod error;

pub use band::{Band, MAX_HEIGHT, MAX_WIDTH};
pub(crate) use band::{CELL, CELL_ROWS, MAX_BANDS, Rough, RoughRow, TILE_HEIGHT, TILE_WIDTH};
pub use error::Error;

use crate::presentation::Presentation;
use glam::{Vec2, vec2};

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
    /// The number of probes that take less than 1 % of a default frame of 1024x768 (0.8 % of the
    /// model scene's instructions, AVX2).
    pub const PROBES: u16 = 80;

    /// Returns a frame without gaps between rows. [`Renderer::render`](crate::Renderer::render)
    /// checks the sizes.
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

    /// Moves samples `x` pixels right and `y` down, -0.5 to 0.5 each. For supersampling, average
    /// frames whose offsets cover a pixel evenly.
    #[must_use]
    pub const fn with_offset(self, x: f32, y: f32) -> Self {
        Self { offset: vec2(x, y), ..self }
    }

    /// Traces `count` pixels as [`Quality::reference`](crate::Quality::reference) does, and
    /// compares them with the frame, which stays unchanged. The results are in
    /// [`Counts::probes`](crate::Counts::probes).
    ///
    /// Pass the frame's number as the seed: consecutive seeds probe different pixels until each was
    /// probed once. Probes ignore captions, and pixels with a
    /// [`Method`](crate::presentation::Method) overlay or coarse squares.
    ///
    /// The estimated mean squared error is unbiased. A few pixels have most of it, so add the
    /// probes of many frames: at 60 frames a second it is accurate to 2 dB after a second, and to
    /// some tenths of a dB after a minute.
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
    pub(crate) fn validate(&self) -> Result<(), Error> {
        let &Self { width, height, stride, .. } = self;
        if !(1..=MAX_WIDTH).contains(&width) || !(1..=MAX_HEIGHT).contains(&height) {
            return Err(Error::Size { width, height });
        }
        if stride < width {
            return Err(Error::Stride { width, stride });
        }
        let (needed, given) = (self.count(), self.pixels.len());
        if given < needed {
            return Err(Error::Pixels { needed, given });
        }
        Ok(())
    }

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
