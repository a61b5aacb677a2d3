//! Draws words and shapes on bitmaps. The font comes with the program, so that the system needs none.

use anyhow::Result;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::{FontStyle, register_font};
use std::sync::Once;

/// The factor by which all is drawn larger and then reduced, to antialias it.
pub const SAMPLES: usize = 2;

/// The colour of words.
pub const INK: RGBColor = RGBColor(34, 34, 34);

/// What is drawn on. Coordinates are pixels of the bitmap times [`SAMPLES`]; see [`at`].
pub type Area<'a> = DrawingArea<BitMapBackend<'a>, Shift>;

/// The `0x00RRGGBB` pixels of a bitmap that has the colour `paper` where nothing is drawn on it.
pub fn bitmap(
    size: [usize; 2],
    paper: u32,
    draw: impl FnOnce(&Area<'_>) -> Result<()>,
) -> Result<Vec<u32>> {
    register_fonts();
    let [columns, rows] = size.map(|side| side * SAMPLES);
    let [_, paper @ ..] = paper.to_be_bytes();
    let mut rgb = paper.repeat(columns * rows);
    let area = BitMapBackend::with_buffer(&mut rgb, (columns as u32, rows as u32));
    let area = area.into_drawing_area();
    draw(&area)?;
    area.present()?;
    drop(area);
    Ok(reduced(&rgb, columns))
}

/// A pixel of the bitmap on its [`Area`].
pub fn at([x, y]: [usize; 2]) -> (i32, i32) {
    ((x * SAMPLES) as i32, (y * SAMPLES) as i32)
}

/// A text style of a size in units, each of which is `scale` pixels.
pub fn text(size: u32, scale: usize, style: FontStyle) -> TextStyle<'static> {
    let size = f64::from(size) * scale as f64;
    FontDesc::new(FontFamily::SansSerif, size, style).color(&INK)
}

/// Registers the font. This has to be called before any text is drawn or measured.
pub fn register_fonts() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        for (style, font) in [
            (FontStyle::Normal, ttf_noto_sans::REGULAR),
            (FontStyle::Bold, ttf_noto_sans::BOLD),
        ] {
            let registered = register_font("sans-serif", style, font);
            assert!(registered.is_ok(), "the font is valid");
        }
    });
}

/// The pixels of which each is the mean of [`SAMPLES`] times [`SAMPLES`] of an RGB bitmap.
fn reduced(rgb: &[u8], columns: usize) -> Vec<u32> {
    let rows = rgb.chunks_exact(3 * columns * SAMPLES);
    rows.flat_map(|rows| {
        (0..columns / SAMPLES).map(move |x| {
            let mean = |channel: usize| {
                let lines = rows.chunks_exact(3 * columns);
                let pixels =
                    lines.flat_map(|line| &line.as_chunks::<3>().0[x * SAMPLES..][..SAMPLES]);
                let sum: usize = pixels.map(|pixel| usize::from(pixel[channel])).sum();
                (sum / (SAMPLES * SAMPLES)) as u8
            };
            u32::from_be_bytes([0, mean(0), mean(1), mean(2)])
        })
    })
    .collect()
}
