//! A contact sheet: frames spread evenly over a film, side by side, each with its time.

use super::crew::Crew;
use crate::arguments::{BadInput, Size};
use crate::plot::{register_fonts, smoothed, text};
use crate::{output, picture, progress};
use anyhow::{Result, anyhow};
use plotters::prelude::*;
use plotters::style::FontStyle;
use std::ops::Range;
use std::path::Path;

/// Pixels between frames, and around them.
const GAP: usize = 8;
/// Rows of pixels under a frame for its time.
const CAPTION: usize = 18;
/// What is between them: a dark grey that no frame is lost in.
const PAPER: u32 = 0x0020_2020;
/// Text is drawn larger and reduced, which smooths it.
const SAMPLES: usize = 2;
/// The longest side of a sheet in pixels: what viewers and graphics cards show.
const LONGEST: usize = 16_384;

/// Writes a sheet of `count` frames.
pub fn write(crew: &Crew<'_>, range: Range<usize>, count: usize, name: &Path) -> Result<()> {
    if count > range.len() {
        let length = range.len();
        return Err(BadInput::error(format!(
            "--frames {count} takes no more than there are: {length}"
        )));
    }
    let columns = columns(count);
    let tile = crew.film.size;
    let sheet = Size {
        width: GAP + columns * (tile.width + GAP),
        height: GAP + count.div_ceil(columns) * (tile.height + CAPTION + GAP),
    };
    if sheet.width.max(sheet.height) > LONGEST {
        return Err(BadInput::error(format!(
            "--size {tile} takes less for {count} frames: a sheet of them is {sheet}, the largest {LONGEST} a side"
        )));
    }
    output::check(name)?;
    let frames: Vec<usize> = (0..count).map(|i| spread(&range, i, count)).collect();
    let mut pixels = vec![PAPER; sheet.area()];
    let bar = progress::bar(count);
    let mut place = 0;
    let done = crew.draw(
        &frames,
        |number, pixels| {
            let time = caption(crew.film.time(number), tile.width)?;
            Ok([pixels, &time].concat())
        },
        |frame| {
            let (column, row) = (place % columns, place / columns);
            let (left, top) = (
                GAP + column * (tile.width + GAP),
                GAP + row * (tile.height + CAPTION + GAP),
            );
            for (y, line) in frame.chunks_exact(tile.width).enumerate() {
                pixels[(top + y) * sheet.width + left..][..tile.width].copy_from_slice(line);
            }
            place += 1;
            bar.inc(1);
            Ok(())
        },
    );
    bar.finish_and_clear();
    done?;
    output::write(name, &picture::png(sheet.width, &pixels)?)?;
    let numbers: Vec<String> = frames.iter().map(usize::to_string).collect();
    eprintln!(
        "{}: frames {}, row by row",
        name.display(),
        numbers.join(" ")
    );
    Ok(())
}

/// A time in seconds, as a strip of pixels for below a frame.
fn caption(time: f32, width: usize) -> Result<Vec<u32>> {
    register_fonts();
    let (columns, rows) = (width * SAMPLES, CAPTION * SAMPLES);
    let [_, paper @ ..] = PAPER.to_be_bytes();
    let mut rgb = paper.repeat(columns * rows);
    let area = BitMapBackend::with_buffer(&mut rgb, (columns as u32, rows as u32));
    let area = area.into_drawing_area();
    let style = text(12, SAMPLES as u32, FontStyle::Normal).color(&WHITE);
    area.draw_text(&format!("{time:.2} s"), &style, (0, 2 * SAMPLES as i32))
        .and_then(|()| area.present())
        .map_err(|error| anyhow!("{error}"))?;
    drop(area);
    Ok(smoothed(&rgb, columns, SAMPLES))
}

/// The frame in the middle of part `i` of `count` equal parts of a range.
fn spread(range: &Range<usize>, i: usize, count: usize) -> usize {
    range.start + (2 * i + 1) * range.len() / (2 * count)
}

/// Columns for so many frames: among numbers from as many columns as rows to twice that, one that leaves the fewest
/// places empty, and of these the least.
fn columns(count: usize) -> usize {
    let least = (count as f64).sqrt().ceil() as usize;
    let empty = |&columns: &usize| count.next_multiple_of(columns) - count;
    (least..=2 * least).min_by_key(empty).unwrap_or(1)
}
