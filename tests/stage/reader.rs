use std::io::Cursor;

/// Decodes an 8-bit RGB PNG file. Returns the width and the `0x00RRGGBB` pixels.
pub fn read_png(bytes: &[u8]) -> (usize, Vec<u32>) {
    let mut reader = png::Decoder::new(Cursor::new(bytes)).read_info().expect("a PNG header");
    let mut rgb = vec![0; reader.output_buffer_size().expect("a size")];
    let info = reader.next_frame(&mut rgb).expect("whole data");
    assert_eq!(info.color_type, png::ColorType::Rgb);
    (info.width as usize, pixels(&rgb))
}

pub fn pixels(rgb: &[u8]) -> Vec<u32> {
    let pixels = rgb.chunks_exact(3);
    pixels.map(|rgb| u32::from_be_bytes([0, rgb[0], rgb[1], rgb[2]])).collect()
}

pub fn read_ppm(bytes: &[u8]) -> (usize, Vec<u32>) {
    let mut parts = bytes.splitn(4, u8::is_ascii_whitespace);
    let mut word = || std::str::from_utf8(parts.next().expect("a word")).expect("text");
    assert_eq!(word(), "P6");
    let side = |word: &str| word.parse::<usize>().expect("a number");
    let (width, height) = (side(word()), side(word()));
    let rest = parts.next().expect("the largest number and the pixels");
    let rgb = rest.strip_prefix(b"255\n").expect("8 bits a channel");
    assert_eq!(rgb.len(), width * height * 3, "whole data");
    (width, pixels(rgb))
}
