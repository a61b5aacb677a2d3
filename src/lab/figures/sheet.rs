//! Puts pictures side by side, each with a caption. Coordinates are pixels of the sheet.

use crate::plot::{register_fonts, smoothed, text};
use anyhow::{Result, anyhow};
use plotters::prelude::*;
use plotters::style::FontStyle;

/// The number of pictures per row.
const COLUMNS: usize = 2;
/// Pixels between pictures and around them.
const GAP: usize = 16;
/// The height of a caption in pixels: a title and a line under it.
const CAPTION: usize = 46;
/// The factor by which text is drawn larger and then reduced, to antialias it.
const SAMPLES: u32 = 2;

/// A picture and its caption.
pub struct Figure {
    /// The name of its file, without the extension.
    pub name: &'static str,
    pub title: &'static str,
    pub caption: String,
    pub pixels: Vec<u32>,
}

/// Draws all figures, each `width` by `height`, on a white sheet. Returns the sheet's width and its pixels.
pub fn sheet(figures: &[Figure], width: usize, height: usize) -> Result<(usize, Vec<u32>)> {
    let rows = figures.len().div_ceil(COLUMNS);
    let (across, down) = (width + GAP, height + CAPTION + GAP);
    let (sheet_width, sheet_height) = (COLUMNS * across + GAP, rows * down + GAP);
    let position = |i: usize| (GAP + i % COLUMNS * across, GAP + i / COLUMNS * down);

    let size = (sheet_width as u32 * SAMPLES, sheet_height as u32 * SAMPLES);
    let mut rgb = vec![255; 3 * (size.0 * size.1) as usize];
    register_fonts();
    let area = BitMapBackend::with_buffer(&mut rgb, size).into_drawing_area();
    for (i, figure) in figures.iter().enumerate() {
        let (x, y) = position(i);
        let at = |below: usize| {
            let scale = SAMPLES as i32;
            (x as i32 * scale, (y + height + below) as i32 * scale)
        };
        let title = text(15, SAMPLES, FontStyle::Bold);
        let caption = text(13, SAMPLES, FontStyle::Normal);
        area.draw_text(figure.title, &title, at(5))
            .and_then(|()| area.draw_text(&figure.caption, &caption, at(25)))
            .map_err(|error| anyhow!("{error}"))?;
    }
    area.present().map_err(|error| anyhow!("{error}"))?;
    drop(area);

    let mut pixels = smoothed(&rgb, size.0 as usize, SAMPLES as usize);
    for (i, figure) in figures.iter().enumerate() {
        let (x, y) = position(i);
        for (row, line) in figure.pixels.chunks_exact(width).enumerate() {
            pixels[(y + row) * sheet_width + x..][..width].copy_from_slice(line);
        }
    }
    Ok((sheet_width, pixels))
}
