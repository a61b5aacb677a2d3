//! Pictures as PNG files.

use anyhow::Result;

/// A picture in `0x00RRGGBB`, row after row, as the bytes of a PNG file.
pub fn png(width: usize, pixels: &[u32]) -> Result<Vec<u8>> {
    let height = pixels.len() / width;
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, u32::try_from(width)?, u32::try_from(height)?);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let rgb: Vec<u8> = pixels
        .iter()
        .flat_map(|p| [p >> 16, p >> 8, *p].map(|c| c as u8))
        .collect();
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&rgb)?;
    writer.finish()?;
    Ok(bytes)
}
