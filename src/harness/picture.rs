//! Pixels are `0x00RRGGBB`.

use png::{BitDepth, ColorType, Encoder, EncodingError};

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
