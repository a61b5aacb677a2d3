//! Pictures as PNG files.

use png::{BitDepth, ColorType, Encoder, EncodingError};

/// A picture in `0x00RRGGBB`, row after row, as the bytes of a PNG file.
pub fn png(width: usize, pixels: &[u32]) -> Result<Vec<u8>, EncodingError> {
    let rgb: Vec<u8> = pixels
        .iter()
        .flat_map(|pixel| pixel.to_be_bytes().into_iter().skip(1))
        .collect();
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, width as u32, (pixels.len() / width) as u32);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&rgb)?;
    writer.finish()?;
    Ok(bytes)
}
