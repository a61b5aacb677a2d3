mod balance;
mod cues;
mod levels;
mod melody;
mod onsets;
mod sameness;
mod spectrum;
mod variety;

use eightfold::show;
use eightfold::sound::{RATE, SONG_LENGTH, Synthesizer};
use std::f64::consts::{FRAC_1_SQRT_2, TAU};
use std::sync::OnceLock;

const BAR: usize = 96_000;
const SCENES: usize = show::CUTS.len();

fn song() -> &'static [[f32; 2]] {
    static SONG: OnceLock<Vec<[f32; 2]>> = OnceLock::new();
    SONG.get_or_init(|| {
        let mut samples = vec![[0.0; 2]; SONG_LENGTH as usize];
        Box::<Synthesizer>::default().play(&mut samples);
        samples
    })
}

fn scene(number: usize) -> &'static [[f32; 2]] {
    let end = show::CUTS.get(number + 1).unwrap_or(&show::BARS);
    &song()[show::CUTS[number] as usize * BAR..*end as usize * BAR]
}

fn scenes() -> impl Iterator<Item = &'static [[f32; 2]]> {
    (0..SCENES).map(scene)
}

fn peak(samples: &[[f32; 2]]) -> f32 {
    samples.as_flattened().iter().fold(0.0, |peak, sample| peak.max(sample.abs()))
}

/// Returns the amplitude of a level in dB of full scale.
fn amplitude(level: f32) -> f32 {
    10_f32.powf(level / 20.0)
}

/// Filters with 12 dB per octave, by the bilinear transform (Bristow-Johnson, "Audio EQ cookbook").
fn high_pass(samples: &[[f32; 2]], hertz: f64) -> Vec<[f32; 2]> {
    let (sin, cos) = (TAU * hertz / f64::from(RATE)).sin_cos();
    let alpha = sin * FRAC_1_SQRT_2;
    let gain = (1.0 + cos) / 2.0 / (1.0 + alpha);
    let (a1, a2) = (-2.0 * cos / (1.0 + alpha), (1.0 - alpha) / (1.0 + alpha));
    let mut states = [[0.0; 2]; 2];
    let pass = |sample: &[f32; 2]| {
        [0, 1].map(|side| {
            let x = f64::from(sample[side]);
            let [s1, s2] = states[side];
            let y = gain * x + s1;
            states[side] = [s2 - 2.0 * gain * x - a1 * y, gain * x - a2 * y];
            y as f32
        })
    };
    samples.iter().map(pass).collect()
}
