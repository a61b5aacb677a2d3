//! The soundtrack has the loudness of music, a dynamic structure, and no DC offset.

use super::{BAR, decibels, peak, song};
use ebur128::{EbuR128, Mode};
use eightfold::show;
use eightfold::sound::RATE;

/// The loudness by EBU R128 in LUFS, and the largest peak between samples.
fn meter(samples: &[[f32; 2]]) -> (f64, f64) {
    let mut meter = EbuR128::new(2, RATE, Mode::I | Mode::TRUE_PEAK).unwrap();
    meter.add_frames_f32(samples.as_flattened()).unwrap();
    let peak = f64::max(meter.true_peak(0).unwrap(), meter.true_peak(1).unwrap());
    (meter.loudness_global().unwrap(), peak)
}

#[test]
fn the_song_is_as_loud_as_music_is() {
    let (loudness, true_peak) = meter(song());
    assert!((-16.0..=-12.0).contains(&loudness), "{loudness} LUFS");
    assert!(peak(song()) <= decibels(-1.0), "{}", peak(song()));
    assert!(
        true_peak <= decibels(-1.0).into(),
        "{true_peak} between samples"
    );
}

#[test]
fn the_song_has_a_build_a_break_and_a_climax() {
    let loudness = |from: u32, to: u32| meter(&song()[from as usize * BAR..to as usize * BAR]).0;
    let title = loudness(show::cut("title"), show::cut("model"));
    let model = loudness(show::cut("model"), show::cut("method"));
    let method = loudness(show::cut("method"), show::cut("colonnade"));
    let colonnade = loudness(show::cut("colonnade"), show::cut("machine"));
    let field = loudness(show::cut("swarm"), show::cut("finale"));
    let finale = loudness(show::cut("finale"), show::BARS);
    assert!(
        title + 2.0 < model && model + 1.0 < method,
        "{title} {model} {method}"
    );
    assert!(colonnade + 3.0 < method, "{colonnade} after {method}");
    assert!(
        field + 0.2 > method && finale + 3.0 < field,
        "{method} {field} {finale}"
    );
}

#[test]
fn no_bar_but_the_last_two_is_silent() {
    let bars = song().chunks_exact(BAR).take(show::BARS as usize - 2);
    for (bar, samples) in bars.enumerate() {
        let (loudness, _) = meter(samples);
        assert!(loudness > -24.0, "bar {bar}: {loudness} LUFS");
    }
}

#[test]
fn it_begins_and_ends_in_silence() {
    let song = song();
    assert!(peak(&song[..1]) < decibels(-50.0), "{}", peak(&song[..1]));
    let end = &song[song.len() - RATE as usize / 4..];
    assert!(peak(end) < decibels(-60.0), "{}", peak(end));
}

#[test]
fn both_sides_are_centred_and_as_loud_as_each_other() {
    let sums = [0, 1].map(|side| {
        let side = song().iter().map(|sample| f64::from(sample[side]));
        (
            side.clone().sum::<f64>(),
            side.map(|sample| sample * sample).sum::<f64>(),
        )
    });
    for (sum, _) in sums {
        let mean = sum / song().len() as f64;
        assert!(mean.abs() < 1e-3, "mean {mean}");
    }
    let ratio = sums[0].1 / sums[1].1;
    assert!(
        (0.8..1.25).contains(&ratio),
        "left {ratio} times the right's energy"
    );
}

/// A click would be a step much larger than those around it.
#[test]
fn cuts_are_no_louder_steps_than_the_music_around_them() {
    let song = song();
    let step = |at: usize| {
        (0..2)
            .map(|side| (song[at][side] - song[at - 1][side]).abs())
            .fold(0.0, f32::max)
    };
    for cut in &show::CUTS[1..] {
        let at = *cut as usize * BAR;
        let around = (at - BAR..at + BAR).map(step).fold(0.0, f32::max);
        let here = (at - 2..at + 2).map(step).fold(0.0, f32::max);
        assert!(here < 0.5 * around, "bar {cut}: {here}, {around}");
    }
}
