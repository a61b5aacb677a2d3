mod balance;
mod cues;
mod levels;
mod melody;
mod onsets;
mod sameness;
mod spectrum;
mod variety;

use eightfold::show;
use eightfold::sound::{SONG_LENGTH, Synthesizer};
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
