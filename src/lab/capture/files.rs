//! A PNG file per frame.

use super::crew::Crew;
use super::film::Film;
use crate::{output, picture, progress};
use anyhow::{Context, Result};
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// The name of a frame's file. The numbers have six digits, so that names sort as frames follow each other.
fn path(folder: &Path, frame: usize) -> PathBuf {
    folder.join(format!("frame-{frame:06}.png"))
}

/// Draws the frames whose files are not there yet, whole and of the same film.
pub fn write(crew: &Crew<'_>, frames: Range<usize>, folder: &Path) -> Result<()> {
    let film = crew.film;
    fs::create_dir_all(folder).with_context(|| format!("cannot make {}", folder.display()))?;
    let count = frames.len();
    let bar = progress::bar(count);
    let missing = missing(crew, frames, folder)?;
    let kept = count - missing.len();
    bar.inc(kept as u64);
    // A bar that reckoned with what was there already would promise too much.
    bar.reset_eta();
    let make =
        |frame, pixels: &[u32]| output::write(&path(folder, frame), &png(film, frame, pixels)?);
    let done = crew.draw(&missing, make, |()| {
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

/// A frame's file: how it was made is in there.
fn png(film: &Film, frame: usize, pixels: &[u32]) -> Result<Vec<u8>> {
    let made = film.describe(frame);
    Ok(picture::png_of(film.size.width, pixels, &made)?)
}

/// The frames whose files are not there, whole and of the same film.
///
/// The first and the last of those that are there are drawn again: if they come out otherwise, the tracer has changed
/// since, and the frames would not fit together.
fn missing(crew: &Crew<'_>, frames: Range<usize>, folder: &Path) -> Result<Vec<usize>> {
    let film = crew.film;
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
    crew.draw(&[first, last], is_the_same, |fits| {
        all_fit &= fits;
        Ok(())
    })?;
    Ok(if all_fit { missing } else { frames.collect() })
}
