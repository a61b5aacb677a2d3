//! The sound of frames.

use super::film::Film;
use crate::{output, wav};
use anyhow::Result;
use std::ops::Range;
use std::path::Path;

/// Writes what is heard while some frames are seen as a WAV file, if anything is.
pub fn write(film: &Film, frames: &Range<usize>, name: &Path) -> Result<()> {
    match bytes(film, frames) {
        Some(bytes) => output::write(name, &bytes),
        None => Ok(()),
    }
}

/// What is heard while some frames are seen, as the bytes of a WAV file; none where nothing is played to the scene.
pub fn bytes(film: &Film, frames: &Range<usize>) -> Option<Vec<u8>> {
    let samples = film.samples(frames)?;
    Some(wav::wav(&wav::record(samples)))
}
