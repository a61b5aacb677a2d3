//! The sound that belongs to frames.

use super::film::Film;
use crate::{output, wav};
use anyhow::Result;
use std::ops::Range;
use std::path::Path;

/// Writes the sound of a range of frames as a WAV file, if the scene has any.
pub fn write(film: &Film, frames: &Range<usize>, name: &Path) -> Result<()> {
    match bytes(film, frames) {
        Some(bytes) => output::write(name, &bytes),
        None => Ok(()),
    }
}

/// The sound of a range of frames as a WAV file; `None` if the scene has none.
pub fn bytes(film: &Film, frames: &Range<usize>) -> Option<Vec<u8>> {
    let samples = film.samples(frames)?;
    Some(wav::wav(&wav::record(samples)))
}
