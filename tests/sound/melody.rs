//! The theme can be heard: after a note starts, its pitch is the strongest of the theme's eight.

use super::{cues, song};
use eightfold::show;
use eightfold::sound::{RATE, THEME, Track};
use rustfft::num_complex::Complex;
use std::f64::consts::{PI, TAU};

const BEAT: f64 = 24_000.0;

/// The finale's first bar, in A major: G, F and C are sharp.
const MAJOR: f32 = 52.0;
const SHARP: [u8; 8] = [0, 1, 0, 1, 1, 0, 0, 0];

/// Returns the power of a frequency, the sum of the left and right channels.
fn power(samples: &[Complex<f64>], hertz: f64) -> f64 {
    // A sample's real part is the left side, its imaginary part the right. The powers at the
    // frequency and at its negative add up to the power of left and right together.
    let turn = Complex::from_polar(1.0, TAU * hertz / f64::from(RATE));
    let (mut phase, mut sums) = (Complex::new(1.0, 0.0), [Complex::<f64>::default(); 2]);
    for sample in samples {
        sums = [sums[0] + sample * phase, sums[1] + sample * phase.conj()];
        phase *= turn;
    }
    sums.iter().map(Complex::norm_sqr).sum()
}

fn windowed(samples: &[[f32; 2]]) -> Vec<Complex<f64>> {
    let hann = |i: usize| (PI * i as f64 / samples.len() as f64).sin().powi(2);
    let samples = samples.iter().enumerate();
    samples
        .map(|(i, side)| Complex::new(f64::from(side[0]), f64::from(side[1])) * hann(i))
        .collect()
}

/// Returns the number of a track's notes, and the notes whose pitch is not the strongest. The track
/// plays `down` semitones below the theme.
fn heard(track: Track, down: u8) -> (usize, Vec<(f32, u8)>) {
    let notes = cues::notes(track, 0, show::BARS);
    let ends = notes.iter().skip(1).map(|&(beat, _)| beat).chain([232.0]);
    let is_weak = |&((beat, digit), end): &((f32, u8), f32)| {
        // From 10 ms on, for up to a beat; longer for the lowest notes, whose pitches are close.
        let longest = if down == 36 { 4.0 } else { 1.0 };
        let length = f32::min(end - beat, longest);
        let sample = |beat: f32| (f64::from(beat) * BEAT) as usize;
        let samples = windowed(&song()[sample(beat) + 480..sample(beat + length)]);
        let powers = [0, 1, 2, 3, 4, 5, 6, 7].map(|i| {
            let sharp = if beat < MAJOR * 4.0 { 0 } else { SHARP[i] };
            let note = f64::from(THEME[i] + sharp - down);
            let hertz = 440.0 * f64::exp2((note - 69.0) / 12.0);
            // Detuned oscillators are up to 10 cents off.
            [0.994, 1.0, 1.006].map(|cents| power(&samples, hertz * cents)).iter().sum::<f64>()
        });
        let strongest = powers.iter().copied().fold(0.0, f64::max);
        powers[usize::from(digit) - 1] < strongest
    };
    let weak = notes.iter().copied().zip(ends).filter(is_weak).map(|(note, _)| note);
    (notes.len(), weak.collect())
}

#[test]
fn every_chime_is_heard() {
    let (notes, weak) = heard(Track::Chime, 0);
    assert!(notes >= 24 && weak.is_empty(), "{notes}: {weak:?}");
}

#[test]
fn most_notes_of_the_theme_are_heard() {
    use Track::{Lead, Marimba, Pop, Square, Strings, Sub};
    let tracks = [(Sub, 36), (Strings, 0), (Lead, 0), (Marimba, 12), (Square, 12), (Pop, 0)];
    let heard = tracks.map(|(track, down)| heard(track, down));
    let notes: usize = heard.iter().map(|(notes, _)| notes).sum();
    let weak: usize = heard.iter().map(|(_, weak)| weak.len()).sum();
    assert!(notes > 150 && weak * 20 <= notes, "{heard:?}");
}
