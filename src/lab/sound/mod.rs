//! `lab sound`: measures the soundtrack and draws its waveform and its spectrogram.

mod axes;
mod levels;
mod spectrogram;
mod waveform;

use crate::timing::thread_time;
use crate::{arguments, output, picture, wav};
use anyhow::Result;
use axes::Heights;
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

/// The size of the pictures in pixels, without their axes: about 40 columns per bar.
const SIZE: (usize, usize) = (1920, 480);

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
    let (width, height) = SIZE;
    if let Some(file) = &arguments.waveform {
        write(
            file,
            &waveform::draw(&samples, width, height),
            &waveform::heights(),
        )?;
    }
    if let Some(file) = &arguments.spectrogram {
        write(
            file,
            &spectrogram::draw(&samples, width, height),
            &spectrogram::heights(),
        )?;
    }
    Ok(())
}

/// Writes a picture with its axes.
fn write(file: &Path, drawn: &[u32], heights: &Heights) -> Result<()> {
    let (width, pixels) = axes::framed(drawn, heights)?;
    output::write(file, &picture::png(width, &pixels)?)
}
