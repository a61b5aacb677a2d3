//! Writes one PNG file per frame.

use super::film::Film;
use super::frame_queue::FrameQueue;
use crate::{output, picture, progress};
use anyhow::{Context, Result};
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// The path of a frame's file. Numbers have six digits, so that sorting by name sorts by number.
fn path(folder: &Path, frame: usize) -> PathBuf {
    folder.join(format!("frame-{frame:06}.png"))
}

/// Draws the frames whose files are missing, incomplete or of another film.
pub fn write(queue: &FrameQueue<'_>, frames: Range<usize>, folder: &Path) -> Result<()> {
    let film = queue.film;
    fs::create_dir_all(folder).with_context(|| format!("cannot make {}", folder.display()))?;
    let count = frames.len();
    let bar = progress::bar(count);
    let missing = missing(queue, frames, folder)?;
    let kept = count - missing.len();
    bar.inc(kept as u64);
    // The estimate of the time left must not count frames that were there already.
    bar.reset_eta();
    let make =
        |frame, pixels: &[u32]| output::write(&path(folder, frame), &png(film, frame, pixels)?);
    let done = queue.draw(&missing, make, |()| {
        bar.inc(1);
        Ok(())
    });
    bar.finish_and_clear();
    done?;
    eprintln!(
        "{}: {} frames drawn, {kept} kept",
        folder.display(),
        missing.len()
    );
    Ok(())
}

/// Encodes a frame, with a description of how it was made.
fn png(film: &Film, frame: usize, pixels: &[u32]) -> Result<Vec<u8>> {
    let made = film.describe(frame);
    Ok(picture::encode(film.size.width, pixels, Some(&made))?)
}

/// The frames whose files are missing, incomplete or of another film.
///
/// The first and the last of the existing frames are drawn again. If they differ, the tracer has changed in between, and all
/// frames are drawn.
fn missing(queue: &FrameQueue<'_>, frames: Range<usize>, folder: &Path) -> Result<Vec<usize>> {
    let film = queue.film;
    let is_whole = |&frame: &usize| {
        let bytes = fs::read(path(folder, frame));
        bytes.is_ok_and(|bytes| picture::is_whole(&bytes, &film.describe(frame)))
    };
    let (there, missing): (Vec<usize>, Vec<usize>) = frames.clone().partition(is_whole);
    let (Some(&first), Some(&last)) = (there.first(), there.last()) else {
        return Ok(missing);
    };
    let is_the_same = |frame: usize, pixels: &[u32]| {
        let bytes = fs::read(path(folder, frame)).unwrap_or_default();
        Ok(bytes == png(film, frame, pixels)?)
    };
    let mut all_fit = true;
    queue.draw(&[first, last], is_the_same, |fits| {
        all_fit &= fits;
        Ok(())
    })?;
    Ok(if all_fit { missing } else { frames.collect() })
}
