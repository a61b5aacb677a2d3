use anyhow::Result;
use eightfold_harness::{Size, picture};
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
    Ok(picture::from_rgb(&rgb))
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

pub struct Tile {
    pub pixels: Vec<u32>,
    pub caption: String,
}

/// Pixels.
const GAP: usize = 12;
/// Pixels.
const LINE: usize = 18;
const PAPER: u32 = 0x00ff_ffff;

pub fn sheet(size: Size, columns: usize, tiles: &[Tile]) -> Result<Vec<u8>> {
    let lines = tiles.iter().map(|tile| tile.caption.lines().count()).max();
    let below = LINE * lines.unwrap_or(0) + 4;
    let (across, down) = (size.width + GAP, size.height + below + GAP);
    let width = GAP + columns * across;
    let height = GAP + tiles.len().div_ceil(columns) * down;
    let place = |i: usize| [GAP + i % columns * across, GAP + i / columns * down];
    let mut pixels = bitmap([width, height], PAPER, |area| {
        for (i, tile) in tiles.iter().enumerate() {
            let [x, y] = place(i);
            for (line, words) in tile.caption.lines().enumerate() {
                let place = at([x, y + size.height + 6 + line * LINE]);
                area.draw_text(words, &text(13), place)?;
            }
        }
        Ok(())
    })?;
    for (i, tile) in tiles.iter().enumerate() {
        let [x, y] = place(i);
        for (row, line) in tile.pixels.chunks_exact(size.width).enumerate() {
            pixels[(y + row) * width + x..][..size.width].copy_from_slice(line);
        }
    }
    Ok(picture::png(width, &pixels)?)
}
