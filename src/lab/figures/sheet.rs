//! Puts pictures side by side, each with a caption. Coordinates are pixels of the sheet.

use crate::bitmap::{Area, at, bitmap, colour, text};
use crate::overlay::heat;
use anyhow::Result;
use plotters::prelude::*;
use plotters::style::FontStyle;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// The number of pictures per row.
const COLUMNS: usize = 2;
/// Pixels between pictures and around them.
const GAP: usize = 16;
/// The height of the line above all pictures in pixels.
const HEADING: usize = 26;
/// The height of a caption in pixels: a title and a line under it.
const CAPTION: usize = 46;
/// The width and the height of a colour bar in pixels.
const BAR: [usize; 2] = [120, 10];
/// A picture and its caption.
pub struct Figure {
    /// The name of its file, without the extension.
    pub name: &'static str,
    pub title: &'static str,
    pub caption: String,
    /// The number that the brightest colour stands for, where the darkest stands for 0.
    pub most: Option<String>,
    pub pixels: Vec<u32>,
}

impl Figure {
    /// A picture whose colours stand for no numbers.
    pub fn new(name: &'static str, title: &'static str, caption: String, pixels: Vec<u32>) -> Self {
        Self {
            name,
            title,
            caption,
            most: None,
            pixels,
        }
    }

    /// The same with colours that stand for numbers from 0 to `most`.
    pub fn up_to(mut self, most: impl ToString) -> Self {
        self.most = Some(most.to_string());
        self
    }
}

/// Draws all figures, each `width` by `height`, on a white sheet with a line above them. Returns the sheet's width and its pixels.
pub fn sheet(
    heading: &str,
    figures: &[Figure],
    width: usize,
    height: usize,
) -> Result<(usize, Vec<u32>)> {
    let rows = figures.len().div_ceil(COLUMNS);
    let (across, down) = (width + GAP, height + CAPTION + GAP);
    let (sheet_width, sheet_height) = (COLUMNS * across + GAP, HEADING + rows * down + GAP);
    let position = |i: usize| {
        (
            GAP + i % COLUMNS * across,
            HEADING + GAP + i / COLUMNS * down,
        )
    };

    let mut pixels = bitmap([sheet_width, sheet_height], 0x00ff_ffff, |area| {
        write(area, heading, 15, [GAP, GAP], false)?;
        for (i, figure) in figures.iter().enumerate() {
            let (x, y) = position(i);
            caption(area, figure, [x, x + width], y + height)?;
        }
        Ok(())
    })?;
    for (i, figure) in figures.iter().enumerate() {
        let (x, y) = position(i);
        for (row, line) in figure.pixels.chunks_exact(width).enumerate() {
            pixels[(y + row) * sheet_width + x..][..width].copy_from_slice(line);
        }
    }
    Ok((sheet_width, pixels))
}

/// Writes a picture's title, its caption and its colour bar below it, between its left and its right end.
fn caption(
    area: &Area<'_>,
    figure: &Figure,
    [left, right]: [usize; 2],
    bottom: usize,
) -> Result<()> {
    write(area, figure.title, 15, [left, bottom + 5], false)?;
    write(area, &figure.caption, 13, [left, bottom + 25], false)?;
    let Some(most) = &figure.most else {
        return Ok(());
    };
    let [width, height] = BAR;
    let start = right.saturating_sub(width);
    let (left, top) = at([start, bottom + 9]);
    let (width, height) = at([width, height]);
    for x in 0..width {
        let colour = colour(heat(x as f32 / (width - 1) as f32));
        let column = [(left + x, top), (left + x, top + height)];
        area.draw(&Rectangle::new(column, colour.filled()))?;
    }
    write(area, "0", 13, [start, bottom + 25], false)?;
    write(area, most, 13, [right, bottom + 25], true)
}

/// Writes words that begin or end at a place. Titles, of 15 pixels, are bold.
fn write(area: &Area<'_>, words: &str, size: u32, place: [usize; 2], is_end: bool) -> Result<()> {
    let style = if size > 13 {
        FontStyle::Bold
    } else {
        FontStyle::Normal
    };
    let from = if is_end { HPos::Right } else { HPos::Left };
    let style = text(size, style).pos(Pos::new(from, VPos::Top));
    Ok(area.draw_text(words, &style, at(place))?)
}
