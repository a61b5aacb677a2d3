//! Pictures side by side, each with its caption.

use crate::plot::{register_fonts, smoothed, text};
use anyhow::{Result, anyhow};
use plotters::prelude::*;
use plotters::style::FontStyle;

/// Pictures in a row.
const COLUMNS: usize = 2;
/// Pixels around and between pictures.
const GAP: usize = 16;
/// Rows of pixels for a caption: its title and a line under it.
const CAPTION: usize = 46;
/// Text is drawn larger and reduced, which smooths it.
const SAMPLES: u32 = 2;

/// A picture with what it shows.
pub struct Figure {
    /// The name of its file, without the ending.
    pub name: &'static str,
    pub title: &'static str,
    pub caption: String,
    pub pixels: Vec<u32>,
}

/// All figures, each `width` by `height`, on white: how wide it is, and its pixels.
pub fn sheet(figures: &[Figure], width: usize, height: usize) -> Result<(usize, Vec<u32>)> {
    let rows = figures.len().div_ceil(COLUMNS);
    let (across, down) = (width + GAP, height + CAPTION + GAP);
    let (sheet_width, sheet_height) = (COLUMNS * across + GAP, rows * down + GAP);
    let place = |i: usize| (GAP + i % COLUMNS * across, GAP + i / COLUMNS * down);

    let size = (sheet_width as u32 * SAMPLES, sheet_height as u32 * SAMPLES);
    let mut rgb = vec![255; 3 * (size.0 * size.1) as usize];
    register_fonts();
    let area = BitMapBackend::with_buffer(&mut rgb, size).into_drawing_area();
    for (i, figure) in figures.iter().enumerate() {
        let (x, y) = place(i);
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
        let (x, y) = place(i);
        for (row, line) in figure.pixels.chunks_exact(width).enumerate() {
            pixels[(y + row) * sheet_width + x..][..width].copy_from_slice(line);
        }
    }
    Ok((sheet_width, pixels))
}
