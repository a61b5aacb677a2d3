//! Pixels are `0x00RRGGBB`.

use eightfold_tracer::{MAX_HEIGHT, MAX_WIDTH};
use png::{BitDepth, ColorType, Encoder, EncodingError};
use std::fmt::{self, Display};
use std::str::FromStr;

/// Returns the pixels of bytes of red, green and blue.
pub fn from_rgb(bytes: &[u8]) -> Vec<u32> {
    let pixels = bytes.as_chunks().0.iter();
    pixels.map(|&[r, g, b]| u32::from_be_bytes([0, r, g, b])).collect()
}

pub fn rgb(pixels: &[u32]) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(3 * pixels.len());
    for pixel in pixels {
        bytes.extend_from_slice(&pixel.to_be_bytes()[1..]);
    }
    bytes
}

#[derive(Default)]
pub struct Mean {
    count: u32,
    sums: Vec<[u32; 3]>,
}

impl Mean {
    pub fn add(&mut self, pixels: &[u32]) {
        self.count += 1;
        self.sums.resize(pixels.len(), [0; 3]);
        for (sum, pixel) in self.sums.iter_mut().zip(pixels) {
            let [_, rgb @ ..] = pixel.to_be_bytes();
            for (sum, channel) in sum.iter_mut().zip(rgb) {
                *sum += u32::from(channel);
            }
        }
    }

    pub fn write(&self, pixels: &mut [u32]) {
        let mean = |sum: u32| ((sum + self.count / 2) / self.count) as u8;
        for (pixel, sum) in pixels.iter_mut().zip(&self.sums) {
            let [r, g, b] = sum.map(mean);
            *pixel = u32::from_be_bytes([0, r, g, b]);
        }
    }
}

pub fn png(width: usize, pixels: &[u32]) -> Result<Vec<u8>, EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, width as u32, (pixels.len() / width) as u32);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&rgb(pixels))?;
    writer.finish()?;
    Ok(bytes)
}

/// In pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    pub width: usize,
    pub height: usize,
}

impl Size {
    pub const fn new(width: usize, height: usize) -> Self {
        Self { width, height }
    }

    pub fn area(self) -> usize {
        self.width * self.height
    }

    /// Scales both sides, to at least 1.
    pub fn scaled(self, scale: f64) -> Self {
        let scaled = |side: usize| ((side as f64 * scale).round() as usize).max(1);
        Self::new(scaled(self.width), scaled(self.height))
    }
}

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let size = text.split_once('x').and_then(|(width, height)| {
            let (width, height) = (width.parse().ok()?, height.parse().ok()?);
            let fits = (1..=MAX_WIDTH).contains(&width) && (1..=MAX_HEIGHT).contains(&height);
            fits.then_some(Self { width, height })
        });
        size.ok_or_else(|| format!("must be WIDTHxHEIGHT, 1x1 to {MAX_WIDTH}x{MAX_HEIGHT}"))
    }
}

impl Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}x{}", self.width, self.height)
    }
}
