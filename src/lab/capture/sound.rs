//! The sound that belongs to frames.

use super::film::Film;
use crate::interrupt::{self, Stopped};
use crate::{output, wav};
use anyhow::{Result, bail};
use std::ops::Range;
use std::path::Path;

/// Writes the sound of a range of frames as a WAV file, if the scene has any.
pub fn write(film: &Film, frames: &Range<usize>, name: &Path) -> Result<()> {
    match bytes(film, frames)? {
        Some(bytes) => output::write(name, &bytes),
        None => Ok(()),
    }
}

/// The sound of a range of frames as a WAV file; `None` if the scene has none.
///
/// # Errors
/// If the command has to end meanwhile.
pub fn bytes(film: &Film, frames: &Range<usize>) -> Result<Option<Vec<u8>>> {
    let Some(samples) = film.samples(frames) else {
        return Ok(None);
    };
    let record = wav::record(samples);
    if interrupt::is_stopped() {
        bail!(Stopped("no sound is written".to_owned()));
    }
    Ok(Some(wav::wav(&record)))
}
