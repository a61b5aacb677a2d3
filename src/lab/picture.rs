//! Pictures of `0x00RRGGBB` pixels, row by row: their bytes, the mean of several, and PNG files.

use png::{BitDepth, ColorType, Compression, Encoder, EncodingError};
use std::io::Cursor;

/// The keyword of the text chunk that describes how the picture was made.
const KEYWORD: &str = "Source";

/// The bytes of red, green and blue of all pixels.
pub fn rgb(pixels: &[u32]) -> Vec<u8> {
    let bytes = pixels.iter().map(|pixel| pixel.to_be_bytes());
    bytes.flat_map(|[_, rgb @ ..]| rgb).collect()
}

/// The mean of pictures that come one by one.
#[derive(Default)]
pub struct Mean {
    count: u32,
    /// Of red, green and blue of all pixels.
    sums: Vec<[u32; 3]>,
}

impl Mean {
    /// Adds a picture of the same size as the others.
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

    /// Gives a picture the mean, rounded.
    pub fn write(&self, pixels: &mut [u32]) {
        let mean = |sum: u32| ((sum + self.count / 2) / self.count) as u8;
        for (pixel, sum) in pixels.iter_mut().zip(&self.sums) {
            let [r, g, b] = sum.map(mean);
            *pixel = u32::from_be_bytes([0, r, g, b]);
        }
    }
}

/// Encodes a picture as a PNG file.
pub fn png(width: usize, pixels: &[u32]) -> Result<Vec<u8>, EncodingError> {
    encode(width, pixels, None)
}

/// Whether these bytes are a complete PNG file with the given description: all pixels are there, and all checksums are right.
pub fn is_whole(bytes: &[u8], made: &str) -> bool {
    let Ok(mut reader) = png::Decoder::new(Cursor::new(bytes)).read_info() else {
        return false;
    };
    let mut texts = reader.info().uncompressed_latin1_text.iter();
    let is_so = texts.any(|text| text.keyword == KEYWORD && text.text == made);
    let Some(size) = reader.output_buffer_size() else {
        return false;
    };
    is_so && reader.next_frame(&mut vec![0; size]).is_ok() && reader.finish().is_ok()
}

/// The same as [`png()`], with a line of ASCII text that describes how the picture was made, if that is told.
pub fn encode(width: usize, pixels: &[u32], made: Option<&str>) -> Result<Vec<u8>, EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, width as u32, (pixels.len() / width) as u32);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    if let Some(made) = made {
        encoder.set_compression(Compression::Fast);
        encoder.add_text_chunk(KEYWORD.to_owned(), made.to_owned())?;
    }
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&rgb(pixels))?;
    writer.finish()?;
    Ok(bytes)
}
