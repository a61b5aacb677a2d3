//! The film: which picture has which number.

use crate::arguments::{NamedQuality, Size};
use crate::rate::Rate;
use crate::scenes::SceneName;
use crate::studio::Studio;
use eightfold::sound::RATE;
use eightfold_window::cpu::Isa;
use std::ops::Range;

/// All that a frame depends on, besides its number: the same bits wherever it is drawn.
pub struct Film {
    pub scene: SceneName,
    pub rate: Rate,
    pub size: Size,
    pub quality: NamedQuality,
    /// A pixel is the mean of so many samples in each direction, 1 to [`MAX_SUPERSAMPLE`].
    pub supersample: usize,
    pub isa: Isa,
}

/// The most samples of a pixel in a direction: 256 of them show every step of an edge in 8 bits.
pub const MAX_SUPERSAMPLE: usize = 16;

/// A picture while it is drawn.
pub struct Canvas {
    studio: Studio,
    pixels: Vec<u32>,
    /// Red, green and blue of each pixel, added up over its samples.
    sums: Vec<[u16; 3]>,
}

impl Film {
    /// When a frame is, in seconds.
    pub fn time(&self, frame: usize) -> f32 {
        (frame as f64 * f64::from(self.rate.den) / f64::from(self.rate.num)) as f32
    }

    /// Frames until the scene's end.
    pub fn length(&self) -> usize {
        let seconds = f64::from(self.scene.length());
        (seconds * f64::from(self.rate.num) / f64::from(self.rate.den)).ceil() as usize
    }

    /// The samples of the soundtrack that are heard while some frames are seen; none where nothing is played to the scene.
    pub fn samples(&self, frames: &Range<usize>) -> Option<Range<u32>> {
        let start = (self.scene.start()? * RATE as f32) as u32;
        let position = |frame: usize| {
            let frames = frame as u64 * u64::from(self.rate.den);
            let samples = (frames * u64::from(RATE)).div_ceil(u64::from(self.rate.num));
            start + samples as u32
        };
        Some(position(frames.start)..position(frames.end))
    }

    /// What a frame's picture is, in a line: equal lines say equal pictures.
    ///
    /// AVX2 and AVX-512 draw the same bits; other instruction sets have no multiplication and addition in one.
    pub fn describe(&self, frame: usize) -> String {
        let lanes = match self.isa.name {
            "avx512" | "avx2" => "fused",
            other => other,
        };
        format!(
            "eightfold {}: scene {}, frame {frame} at {} fps, {}, {:?}, {n}x{n} samples, {lanes}",
            env!("CARGO_PKG_VERSION"),
            self.scene,
            self.rate,
            self.size,
            self.quality.quality,
            n = self.supersample,
        )
    }

    /// Draws a frame: `0x00RRGGBB`, row after row.
    pub fn draw<'a>(&self, frame: usize, canvas: &'a mut Canvas) -> &'a [u32] {
        let scene = self.scene.at(self.time(frame));
        let n = self.supersample;
        let Canvas {
            studio,
            pixels,
            sums,
        } = canvas;
        pixels.resize(self.size.area(), 0);
        sums.clear();
        // Samples in the middle of n by n parts of a pixel, each the pictures of which are one of their own.
        let offset = |part: usize| (part as f32 + 0.5) / n as f32 - 0.5;
        for y in 0..n {
            for x in 0..n {
                studio.set_offset(offset(x), offset(y));
                let (quality, width) = (&self.quality.quality, self.size.width);
                studio.draw(self.isa.level, &scene, quality, width, pixels);
                if n > 1 {
                    add(sums, pixels);
                }
            }
        }
        if n > 1 {
            mean(sums, (n * n) as u16, pixels);
        }
        pixels
    }
}

impl Canvas {
    /// For one thread.
    pub fn new() -> Self {
        Self {
            studio: Studio::new(1),
            pixels: Vec::new(),
            sums: Vec::new(),
        }
    }
}

/// Adds a picture up. 256 samples of at most 255 fit.
fn add(sums: &mut Vec<[u16; 3]>, pixels: &[u32]) {
    sums.resize(pixels.len(), [0; 3]);
    for (sum, pixel) in sums.iter_mut().zip(pixels) {
        let [_, rgb @ ..] = pixel.to_be_bytes();
        for (sum, channel) in sum.iter_mut().zip(rgb) {
            *sum += u16::from(channel);
        }
    }
}

/// The mean of `count` pictures, rounded.
fn mean(sums: &[[u16; 3]], count: u16, pixels: &mut [u32]) {
    for (pixel, sum) in pixels.iter_mut().zip(sums) {
        let [r, g, b] =
            sum.map(|sum| ((u32::from(sum) + u32::from(count / 2)) / u32::from(count)) as u8);
        *pixel = u32::from_be_bytes([0, r, g, b]);
    }
}
