//! `lab sound`: measures the soundtrack and draws its waveform and its spectrogram.

mod levels;
mod pictures;

use crate::timing::thread_time;
use crate::{arguments, output, wav};
use anyhow::Result;
use clap::Args;
use eightfold::sound::{RATE, SONG_LENGTH};
use std::path::{Path, PathBuf};

/// Makes the soundtrack, and prints its levels bar by bar
///
/// Prints a Markdown table: where a scene begins, the largest sample and the loudness (EBU R128) of each bar, and of all.
#[derive(Args)]
pub struct Arguments {
    /// File to write the sound to as WAV, or - for standard output
    #[arg(long, value_name = "FILE")]
    wav: Option<PathBuf>,
    /// File to draw the waveform into as PNG
    #[arg(long, value_name = "FILE", value_parser = arguments::png_file)]
    waveform: Option<PathBuf>,
    /// File to draw the spectrogram into as PNG
    #[arg(long, value_name = "FILE", value_parser = arguments::png_file)]
    spectrogram: Option<PathBuf>,
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> Result<()> {
    let files = [&arguments.wav, &arguments.waveform, &arguments.spectrogram];
    for file in files.into_iter().flatten() {
        output::check(file)?;
    }
    let (samples, time) = thread_time(|| wav::record(0..SONG_LENGTH));
    let table = format!(
        "{}\nMade in {time:.2} s: {:.1} % of one core while it plays.\n",
        levels::markdown(&samples)?,
        100.0 * time * f64::from(RATE) / f64::from(SONG_LENGTH),
    );
    if arguments.wav.as_deref() == Some(Path::new("-")) {
        eprint!("{table}");
    } else {
        output::write(Path::new("-"), table.as_bytes())?;
    }
    if let Some(file) = &arguments.wav {
        output::write(file, &wav::wav(&samples))?;
    }
    if let Some(file) = &arguments.waveform {
        output::write(file, &pictures::waveform(&samples)?)?;
    }
    if let Some(file) = &arguments.spectrogram {
        output::write(file, &pictures::spectrogram(&samples)?)?;
    }
    Ok(())
}
