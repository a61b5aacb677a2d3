//! The film: the picture for each frame number.

use crate::arguments::{NamedQuality, Size};
use crate::rate::Rate;
use crate::scenes::SceneName;
use crate::threaded_renderer::ThreadedRenderer;
use eightfold::sound::RATE;
use eightfold_window::cpu::Isa;
use std::ops::Range;

/// Everything that determines a frame's pixels, except its number.
pub struct Film {
    pub scene: SceneName,
    pub rate: Rate,
    pub size: Size,
    pub quality: NamedQuality,
    /// The number of samples per pixel along each axis, 1 to [`MAX_SUPERSAMPLE`].
    pub supersample: usize,
    pub isa: Isa,
}

/// The most samples per pixel along each axis: 256 samples give every step of an edge in 8 bits.
pub const MAX_SUPERSAMPLE: usize = 16;

/// The working memory for a picture.
pub struct Canvas {
    renderer: ThreadedRenderer,
    pixels: Vec<u32>,
    /// The sums of red, green and blue over the samples of each pixel.
    sums: Vec<[u16; 3]>,
}

impl Film {
    /// The time of a frame in seconds.
    pub fn time(&self, frame: usize) -> f32 {
        self.rate.time(frame)
    }

    /// The number of frames of the scene.
    pub fn length(&self) -> usize {
        self.rate.frames(self.scene.length())
    }

    /// The range of the soundtrack, in samples, that belongs to a range of frames; `None` if the scene has no sound.
    pub fn samples(&self, frames: &Range<usize>) -> Option<Range<u32>> {
        let start = (self.scene.start()? * RATE as f32) as u32;
        let position = |frame: usize| {
            let frames = frame as u64 * u64::from(self.rate.den);
            let samples = (frames * u64::from(RATE)).div_ceil(u64::from(self.rate.num));
            start + samples as u32
        };
        Some(position(frames.start)..position(frames.end))
    }

    /// A line that describes a frame: equal lines mean equal pictures.
    ///
    /// AVX2 and AVX-512 draw the same bits. Other instruction sets lack fused multiply-add.
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

    /// Draws a frame as `0x00RRGGBB` pixels, row by row.
    pub fn draw<'a>(&self, frame: usize, canvas: &'a mut Canvas) -> &'a [u32] {
        let scene = self.scene.at(self.time(frame));
        let n = self.supersample;
        let Canvas {
            renderer,
            pixels,
            sums,
        } = canvas;
        pixels.resize(self.size.area(), 0);
        sums.clear();
        // The samples are the centres of n by n parts of the pixel. Each sample position makes a picture of its own.
        let offset = |part: usize| (part as f32 + 0.5) / n as f32 - 0.5;
        for y in 0..n {
            for x in 0..n {
                renderer.set_offset(offset(x), offset(y));
                let (quality, width) = (&self.quality.quality, self.size.width);
                renderer.draw(self.isa.level, &scene, quality, width, pixels);
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
    /// Working memory for one thread.
    pub fn new() -> Self {
        Self {
            renderer: ThreadedRenderer::new(1),
            pixels: Vec::new(),
            sums: Vec::new(),
        }
    }
}

/// Adds a picture to the sums. 256 samples of at most 255 fit into 16 bits.
fn add(sums: &mut Vec<[u16; 3]>, pixels: &[u32]) {
    sums.resize(pixels.len(), [0; 3]);
    for (sum, pixel) in sums.iter_mut().zip(pixels) {
        let [_, rgb @ ..] = pixel.to_be_bytes();
        for (sum, channel) in sum.iter_mut().zip(rgb) {
            *sum += u16::from(channel);
        }
    }
}

/// Divides the sums by the number of pictures, with rounding.
fn mean(sums: &[[u16; 3]], count: u16, pixels: &mut [u32]) {
    for (pixel, sum) in pixels.iter_mut().zip(sums) {
        let [r, g, b] =
            sum.map(|sum| ((u32::from(sum) + u32::from(count / 2)) / u32::from(count)) as u8);
        *pixel = u32::from_be_bytes([0, r, g, b]);
    }
}
