//! Measures the loudness, bar by bar.

use anyhow::Result;
use ebur128::{EbuR128, Mode};
use eightfold::show::{BARS, CUTS, NAMES};
use eightfold::sound::{RATE, SONG_LENGTH};
use std::fmt::Write;

/// The levels of a piece of sound.
struct Levels {
    /// The largest sample, in dB of full scale.
    peak: f64,
    /// The largest level between samples, in dB of full scale.
    true_peak: f64,
    /// In LUFS; minus infinity for silence.
    loudness: f64,
    /// The magnitude of the samples' mean, in the channel where it is larger.
    mean: f64,
}

impl Levels {
    fn of(samples: &[[f32; 2]]) -> Result<Self> {
        let mut meter = EbuR128::new(2, RATE, Mode::I | Mode::SAMPLE_PEAK | Mode::TRUE_PEAK)?;
        meter.add_frames_f32(samples.as_flattened())?;
        let channels = [0, 1];
        let decibels = |peaks: [f64; 2]| 20.0 * peaks[0].max(peaks[1]).log10();
        let mean = |channel| {
            samples
                .iter()
                .map(|sample| f64::from(sample[channel]))
                .sum::<f64>()
                / samples.len() as f64
        };
        let means = channels.map(|channel: usize| mean(channel).abs());
        Ok(Self {
            peak: decibels([meter.sample_peak(0)?, meter.sample_peak(1)?]),
            true_peak: decibels([meter.true_peak(0)?, meter.true_peak(1)?]),
            loudness: meter.loudness_global()?,
            mean: means[0].max(means[1]),
        })
    }
}

/// A Markdown table of the levels of the song's bars, and a line for the whole song.
pub fn markdown(samples: &[[f32; 2]]) -> Result<String> {
    let mut text = String::from(
        "| bar |     scene | peak dBFS |  LUFS |\n| --: | --------: | --------: | ----: |\n",
    );
    for (bar, samples) in (0..).zip(samples.chunks_exact((SONG_LENGTH / BARS) as usize)) {
        let levels = Levels::of(samples)?;
        let scene = CUTS
            .iter()
            .position(|&cut| cut == bar)
            .map_or("", |cut| NAMES[cut]);
        writeln!(
            text,
            "| {bar:3} | {scene:>9} | {:9.1} | {:5.1} |",
            levels.peak, levels.loudness
        )?;
    }
    let all = Levels::of(samples)?;
    writeln!(
        text,
        "\nAll: peak {:.2} dBFS, {:.2} dB between samples, {:.2} LUFS, mean {:.1e}.",
        all.peak, all.true_peak, all.loudness, all.mean
    )?;
    Ok(text)
}
