use super::{BAR, decibels, peak, song};
use ebur128::{EbuR128, Mode};
use eightfold::show;
use eightfold::sound::RATE;

/// Returns the loudness by EBU R128 in LUFS, and the true peak.
fn meter(samples: &[[f32; 2]]) -> (f64, f64) {
    let mut meter = EbuR128::new(2, RATE, Mode::I | Mode::TRUE_PEAK).unwrap();
    meter.add_frames_f32(samples.as_flattened()).unwrap();
    let peak = f64::max(meter.true_peak(0).unwrap(), meter.true_peak(1).unwrap());
    (meter.loudness_global().unwrap(), peak)
}

#[test]
fn song_loudness_is_near_minus_14_lufs() {
    let (loudness, true_peak) = meter(song());
    assert!((-16.0..=-12.0).contains(&loudness), "{loudness} LUFS");
    assert!(true_peak <= decibels(-1.0).into(), "{true_peak}");
}

#[test]
fn song_has_a_build_a_break_and_a_climax() {
    let cut = |name: &str| show::cut(name) as usize * BAR;
    let loudness = |from: &str, to: &str| meter(&song()[cut(from)..cut(to)]).0;
    let title = loudness("title", "model");
    let model = loudness("model", "method");
    let method = loudness("method", "colonnade");
    let colonnade = loudness("colonnade", "machine");
    let swarm = loudness("swarm", "finale");
    let finale = meter(&song()[cut("finale")..]).0;
    let all = [title, model, method, colonnade, swarm, finale];
    assert!(title + 2.0 < model && model + 1.0 < method, "{all:?}");
    assert!(colonnade + 3.0 < method, "{all:?}");
    assert!(swarm + 0.2 > method && finale + 3.0 < swarm, "{all:?}");
}

#[test]
fn bars_before_the_last_two_are_audible() {
    let bars = song().chunks_exact(BAR).take(show::BARS as usize - 2);
    for (bar, samples) in bars.enumerate() {
        let (loudness, _) = meter(samples);
        assert!(loudness > -24.0, "bar {bar}: {loudness} LUFS");
    }
}

#[test]
fn song_begins_and_ends_in_silence() {
    assert!(peak(&song()[..1]) < decibels(-50.0));
    let (_, end) = song().split_at(song().len() - RATE as usize / 4);
    assert!(peak(end) < decibels(-60.0), "{}", peak(end));
}

#[test]
fn both_sides_are_centred_and_equally_loud() {
    let energies = [0, 1].map(|side| {
        let side = song().iter().map(|sample| f64::from(sample[side]));
        let mean = side.clone().sum::<f64>() / song().len() as f64;
        assert!(mean.abs() < 1e-3, "mean {mean}");
        side.map(|sample| sample * sample).sum::<f64>()
    });
    let ratio = energies[0] / energies[1];
    assert!((0.8..1.25).contains(&ratio), "left to right: {ratio}");
}

/// A click is a step much larger than its neighbours.
#[test]
fn cuts_have_no_clicks() {
    let song = song();
    let largest = |from: usize, to: usize| {
        let steps = song[from - 1..to].windows(2);
        let sides = steps.flat_map(|pair| [0, 1].map(|side| (pair[1][side] - pair[0][side]).abs()));
        sides.fold(0.0, f32::max)
    };
    for cut in &show::CUTS[1..] {
        let at = *cut as usize * BAR;
        let (here, around) = (largest(at - 2, at + 2), largest(at - BAR, at + BAR));
        assert!(here < 0.5 * around, "bar {cut}: {here}, {around}");
    }
}
