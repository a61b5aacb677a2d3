//! Reads pictures back.

use std::io::Cursor;

/// The width and the pixels, `0x00RRGGBB`, of the bytes of a PNG file in 8-bit RGB.
pub fn read_png(bytes: &[u8]) -> (usize, Vec<u32>) {
    let mut reader = png::Decoder::new(Cursor::new(bytes))
        .read_info()
        .expect("a PNG header");
    let mut rgb = vec![0; reader.output_buffer_size().expect("a size")];
    let info = reader.next_frame(&mut rgb).expect("whole data");
    assert_eq!(info.color_type, png::ColorType::Rgb);
    let pixels = rgb
        .chunks_exact(3)
        .map(|c| u32::from_be_bytes([0, c[0], c[1], c[2]]));
    (info.width as usize, pixels.collect())
}
