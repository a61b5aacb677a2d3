use anyhow::Result;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::{FontStyle, register_font};
use std::sync::Once;

pub const INK: RGBColor = RGBColor(34, 34, 34);

pub type Area<'a> = DrawingArea<BitMapBackend<'a>, Shift>;

/// Draws on `paper`, and returns `0x00RRGGBB` pixels.
pub fn bitmap(
    [width, height]: [usize; 2],
    paper: u32,
    draw: impl FnOnce(&Area<'_>) -> Result<()>,
) -> Result<Vec<u32>> {
    register_fonts();
    let [_, paper @ ..] = paper.to_be_bytes();
    let mut rgb = paper.repeat(width * height);
    let area = BitMapBackend::with_buffer(&mut rgb, (width as u32, height as u32));
    let area = area.into_drawing_area();
    draw(&area)?;
    area.present()?;
    drop(area);
    let pixels = rgb.as_chunks().0.iter();
    Ok(pixels.map(|&[r, g, b]| u32::from_be_bytes([0, r, g, b])).collect())
}

pub fn at([x, y]: [usize; 2]) -> (i32, i32) {
    (x as i32, y as i32)
}

/// `size` is in pixels.
pub fn text(size: u32) -> TextStyle<'static> {
    FontDesc::new(FontFamily::SansSerif, f64::from(size), FontStyle::Normal).color(&INK)
}

/// Needed before text is measured or drawn outside of [`bitmap`].
pub fn register_fonts() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let registered = register_font("sans-serif", FontStyle::Normal, ttf_noto_sans::REGULAR);
        assert!(registered.is_ok(), "the font is valid");
    });
}
