//! Pictures as PNG files.

use png::{BitDepth, ColorType, Compression, Encoder, EncodingError};
use std::io::Cursor;

/// The keyword of the text in a picture that says how it was made.
const KEYWORD: &str = "Source";

/// A picture in `0x00RRGGBB`, row after row, as the bytes of a PNG file.
pub fn png(width: usize, pixels: &[u32]) -> Result<Vec<u8>, EncodingError> {
    encode(width, pixels, None)
}

/// As [`png()`], with a line in ASCII that says how the picture was made.
pub fn png_of(width: usize, pixels: &[u32], made: &str) -> Result<Vec<u8>, EncodingError> {
    encode(width, pixels, Some(made))
}

/// Whether these are the bytes of a whole PNG file that says it was made so: every pixel is there, and every checksum
/// fits.
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

fn encode(width: usize, pixels: &[u32], made: Option<&str>) -> Result<Vec<u8>, EncodingError> {
    let rgb: Vec<u8> = pixels
        .iter()
        .flat_map(|pixel| pixel.to_be_bytes().into_iter().skip(1))
        .collect();
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, width as u32, (pixels.len() / width) as u32);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    if let Some(made) = made {
        encoder.set_compression(Compression::Fast);
        encoder.add_text_chunk(KEYWORD.to_owned(), made.to_owned())?;
    }
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&rgb)?;
    writer.finish()?;
    Ok(bytes)
}
