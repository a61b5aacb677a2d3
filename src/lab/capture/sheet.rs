//! Writes a contact sheet: frames at even intervals, side by side, each with its time. Coordinates are pixels of the sheet.

use super::frame_queue::FrameQueue;
use crate::arguments::{BadInput, Size};
use crate::bitmap::{at, bitmap, text};
use crate::{output, picture, progress};
use anyhow::{Result, bail};
use plotters::prelude::*;
use plotters::style::FontStyle;
use std::ops::Range;
use std::path::Path;

/// Pixels between frames and around them.
const GAP: usize = 8;
/// The height in pixels of the strip with the time under a frame.
const CAPTION: usize = 18;
/// The background: a dark grey, against which even black frames stand out.
const PAPER: u32 = 0x0020_2020;
/// The largest side of a sheet in pixels: viewers and graphics cards support no more.
const LONGEST: usize = 16_384;

/// Writes a sheet of `count` frames.
pub fn write(queue: &FrameQueue<'_>, range: Range<usize>, count: usize, name: &Path) -> Result<()> {
    if count > range.len() {
        let length = range.len();
        bail!(BadInput(format!(
            "--frames {count} takes no more than there are: {length}"
        )));
    }
    // Lay the tiles out.
    let columns = columns(count);
    let tile = queue.film.size;
    let sheet = Size {
        width: GAP + columns * (tile.width + GAP),
        height: GAP + count.div_ceil(columns) * (tile.height + CAPTION + GAP),
    };
    if sheet.width.max(sheet.height) > LONGEST {
        bail!(BadInput(format!(
            "--size {tile} takes less for {count} frames: a sheet of them is {sheet}, the largest {LONGEST} a side"
        )));
    }
    output::check(name)?;
    // Draw the frames, each with its time below, into their places.
    let frames: Vec<usize> = (0..count).map(|i| spread(&range, i, count)).collect();
    let mut pixels = vec![PAPER; sheet.area()];
    let bar = progress::bar(count);
    let mut index = 0;
    let done = queue.draw(
        &frames,
        |number, pixels| {
            let time = caption(queue.film.time(number), tile.width)?;
            Ok([pixels, &time].concat())
        },
        |frame| {
            let (column, row) = (index % columns, index / columns);
            let (left, top) = (
                GAP + column * (tile.width + GAP),
                GAP + row * (tile.height + CAPTION + GAP),
            );
            for (y, line) in frame.chunks_exact(tile.width).enumerate() {
                pixels[(top + y) * sheet.width + left..][..tile.width].copy_from_slice(line);
            }
            index += 1;
            bar.inc(1);
            Ok(())
        },
    );
    bar.finish_and_clear();
    done?;
    // Write the sheet, and say what is on it.
    output::write(name, &picture::png(sheet.width, &pixels)?)?;
    let numbers: Vec<String> = frames.iter().map(usize::to_string).collect();
    eprintln!(
        "{}: frames {}, row by row",
        name.display(),
        numbers.join(" ")
    );
    Ok(())
}

/// The strip of pixels with a time in seconds.
fn caption(time: f32, width: usize) -> Result<Vec<u32>> {
    bitmap([width, CAPTION], PAPER, |area| {
        let style = text(12, FontStyle::Normal).color(&WHITE);
        Ok(area.draw_text(&format!("{time:.2} s"), &style, at([0, 1]))?)
    })
}

/// The frame in the middle of part `i` if a range is divided into `count` equal parts.
fn spread(range: &Range<usize>, i: usize, count: usize) -> usize {
    range.start + (2 * i + 1) * range.len() / (2 * count)
}

/// The number of columns for a number of frames. Between as many columns as rows and twice that, it leaves the fewest tiles
/// empty; among equals it is the smallest.
fn columns(count: usize) -> usize {
    let least = (count as f64).sqrt().ceil() as usize;
    let empty = |&columns: &usize| count.next_multiple_of(columns) - count;
    (least..=2 * least).min_by_key(empty).unwrap_or(1)
}
