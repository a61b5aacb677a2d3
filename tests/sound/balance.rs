use super::spectrum::Spectrum;
use super::{cues, scenes, song};
use eightfold::show;
use eightfold::sound::Track;
use std::ops::{Range, RangeInclusive};

/// Bands in Hz, and their levels per octave in dB relative to 500 to 2,000 Hz: masters fall by
/// about 5 dB per octave (Pestana 2013).
type Bounds = [(Range<f64>, RangeInclusive<f64>)];

#[rustfmt::skip]
const ALL: &Bounds = &[
    (250.0..500.0, 0.0..=5.0),
    (2000.0..5000.0, -6.0..=-1.0),
    (5000.0..10_000.0, -11.0..=-3.0),
    (10_000.0..16_000.0, -14.0..=-5.0),
    (16_000.0..20_000.0, -60.0..=-8.0),
];

#[rustfmt::skip]
const DRUMS: &Bounds = &[
    (60.0..120.0, 2.0..=9.0),
    (120.0..250.0, 0.0..=6.0),
];

fn check(name: &str, samples: &[[f32; 2]], bounds: &Bounds) -> Vec<String> {
    let spectrum = Spectrum::new(samples);
    let middle = spectrum.level(500.0..2000.0);
    let levels = bounds.iter().map(|(hertz, allowed)| {
        let level = spectrum.level(hertz.clone()) - middle;
        let is_wrong = !allowed.contains(&level);
        is_wrong.then(|| format!("{name}, {hertz:?} Hz: {level:.1} dB, not {allowed:?}"))
    });
    levels.flatten().collect()
}

#[test]
fn scenes_have_bass_and_treble_of_a_master() {
    let mut wrong = check("song", song(), ALL);
    for (samples, (name, &cut)) in scenes().zip(show::NAMES.iter().zip(&show::CUTS)) {
        wrong.extend(check(name, samples, ALL));
        if !cues::notes(Track::Kick, cut, 4).is_empty() {
            wrong.extend(check(name, samples, DRUMS));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn bass_is_centred_and_the_rest_is_wide() {
    let spectrum = Spectrum::new(song());
    let bounds =
        [(20.0..120.0, 0.95..=1.0), (500.0..2000.0, 0.3..=0.7), (2000.0..6000.0, 0.4..=0.8)];
    for (hertz, allowed) in bounds {
        let correlation = spectrum.correlation(hertz.clone());
        assert!(allowed.contains(&correlation), "{hertz:?} Hz: {correlation}");
    }
}
