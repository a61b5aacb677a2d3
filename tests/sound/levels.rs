//! Loudness by EBU R128, and silence.

use super::{BAR, SCENES, amplitude, peak, scene, scenes, song, spectrum::Spectrum};
use ebur128::{EbuR128, Mode};
use eightfold::show;
use eightfold::sound::RATE;

fn meter(samples: &[[f32; 2]], mode: Mode) -> EbuR128 {
    let mut meter = EbuR128::new(2, RATE, mode).unwrap();
    meter.add_frames_f32(samples.as_flattened()).unwrap();
    meter
}

/// Returns the loudness in LUFS.
fn loudness(samples: &[[f32; 2]]) -> f64 {
    meter(samples, Mode::I).loudness_global().unwrap()
}

#[test]
fn song_loudness_and_its_range_are_of_a_master() {
    let meter = meter(song(), Mode::I | Mode::LRA | Mode::TRUE_PEAK);
    let (loudness, range) = (meter.loudness_global().unwrap(), meter.loudness_range().unwrap());
    assert!((-14.0..=-12.0).contains(&loudness), "{loudness} LUFS");
    assert!((8.0..=12.0).contains(&range), "{range} LU");
    let peak = f64::max(meter.true_peak(0).unwrap(), meter.true_peak(1).unwrap());
    assert!(peak <= amplitude(-1.0).into(), "true peak {peak}");
}

#[test]
fn scenes_differ_and_the_climax_is_loudest() {
    let all: Vec<f64> = scenes().map(loudness).collect();
    assert!(all[0] <= -18.0, "{all:?}");
    assert!(all.windows(2).all(|pair| (pair[0] - pair[1]).abs() >= 1.0), "{all:?}");
    let climax = SCENES - 2;
    for (scene, &other) in all.iter().enumerate().filter(|&(scene, _)| scene != climax) {
        assert!(other + 1.5 <= all[climax], "scene {scene}: {all:?}");
    }
}

#[test]
fn every_bar_is_audible() {
    for (bar, samples) in song().chunks_exact(BAR).enumerate() {
        let loudness = loudness(samples);
        assert!(loudness > -24.0, "bar {bar}: {loudness} LUFS");
    }
}

/// A laptop plays little below 200 Hz. 34 % of the power is above, so 2.4 LU are lost.
#[test]
fn laptop_loses_little_of_the_chimes() {
    let spectrum = Spectrum::new(scene(4));
    let share = spectrum.power(200.0..20_000.0) / spectrum.power(20.0..20_000.0);
    assert!(share >= 0.3, "{share}");
}

#[test]
fn mono_loses_little() {
    for (scene, samples) in scenes().chain([song()]).enumerate() {
        let mono: Vec<_> = samples.iter().map(|[left, right]| [(left + right) / 2.0; 2]).collect();
        let lost = loudness(samples) - loudness(&mono);
        assert!(lost <= 2.0, "scene {scene}: {lost} LU");
    }
}

/// Returns the samples from one time to another, in milliseconds.
fn between(from: usize, to: usize) -> &'static [[f32; 2]] {
    let sample = |time: usize| time * RATE as usize / 1000;
    &song()[sample(from)..sample(to)]
}

#[test]
fn song_is_silent_only_at_its_start_and_end() {
    assert!(peak(&song()[..1]) < amplitude(-50.0));
    assert!(peak(between(115_750, 116_000)) < amplitude(-60.0));
    for start in (0..=115_600).step_by(100) {
        let samples = between(start, start + 100).as_flattened();
        let square = samples.iter().map(|sample| sample * sample).sum::<f32>();
        let level = (square / samples.len() as f32).sqrt();
        assert!(level > amplitude(-50.0), "{start} ms: {level}");
    }
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

#[test]
fn instruments_rest_before_every_cut() {
    for &cut in &show::CUTS[1..] {
        let end = cut as usize * BAR;
        let quaver = BAR / 8;
        let level = |samples| Spectrum::new(samples).power(20.0..20_000.0);
        let rest = level(&song()[end - quaver + 2400..end]) / level(&song()[end - BAR..end]);
        assert!(rest < 0.5, "bar {cut}: {rest}");
    }
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
