//! A sample depends on its position in the song alone.

use super::{BAR, song};
use eightfold::show;
use eightfold::sound::{SONG_LENGTH, Synthesizer};

/// Whether two sequences of samples have the same bits.
fn same(a: &[[f32; 2]], b: &[[f32; 2]]) -> bool {
    let bits = |samples: &[[f32; 2]]| -> Vec<u32> {
        samples
            .as_flattened()
            .iter()
            .map(|sample| sample.to_bits())
            .collect()
    };
    bits(a) == bits(b)
}

#[test]
fn any_blocks_give_the_same_samples() {
    let song = &song()[..8 * BAR];
    for size in [1, 7, 48, 479, 4096] {
        let mut synthesizer = Box::<Synthesizer>::default();
        let mut samples = vec![[0.0; 2]; song.len()];
        samples
            .chunks_mut(size)
            .for_each(|block| synthesizer.play(block));
        assert!(same(&samples, song), "blocks of {size}");
    }
}

#[test]
fn its_own_blocks_are_the_same_samples() {
    let mut synthesizer = Box::<Synthesizer>::default();
    let mut samples = Vec::new();
    while samples.len() < 8 * BAR {
        samples.extend_from_slice(synthesizer.block());
    }
    assert!(same(&samples, &song()[..samples.len()]));
}

#[test]
fn a_bar_gone_to_sounds_as_a_bar_played_to() {
    let mut synthesizer = Box::<Synthesizer>::default();
    // Forwards, backwards, and to the middle of a block.
    for start in
        show::CUTS
            .map(|bar| bar as usize * BAR)
            .into_iter()
            .chain([9 * BAR + 1, 0, 12_345])
    {
        synthesizer.seek(start as u32);
        let mut samples = vec![[0.0; 2]; BAR / 4];
        synthesizer.play(&mut samples);
        assert!(
            same(&samples, &song()[start..][..samples.len()]),
            "from {start}"
        );
    }
}

#[test]
fn after_the_end_comes_the_start() {
    let mut synthesizer = Box::<Synthesizer>::default();
    synthesizer.seek(SONG_LENGTH - 100);
    let mut samples = vec![[0.0; 2]; 10_000];
    synthesizer.play(&mut samples);
    assert!(same(&samples[..100], &song()[song().len() - 100..]));
    assert!(same(&samples[100..], &song()[..samples.len() - 100]));
}
