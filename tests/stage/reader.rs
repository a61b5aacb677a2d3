use eightfold_harness::picture::from_rgb;
use std::io::Cursor;

/// Decodes an 8-bit RGB PNG file. Returns the width and the `0x00RRGGBB` pixels.
pub fn read_png(bytes: &[u8]) -> (usize, Vec<u32>) {
    let mut reader = png::Decoder::new(Cursor::new(bytes)).read_info().expect("a PNG header");
    let mut rgb = vec![0; reader.output_buffer_size().expect("a size")];
    let info = reader.next_frame(&mut rgb).expect("whole data");
    assert_eq!(info.color_type, png::ColorType::Rgb);
    (info.width as usize, from_rgb(&rgb))
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
    (width, from_rgb(rgb))
}
