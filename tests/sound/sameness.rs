use super::{BAR, song};
use eightfold::show;
use eightfold::sound::{SONG_LENGTH, Synthesizer};

fn same(a: &[[f32; 2]], b: &[[f32; 2]]) -> bool {
    let bits = |side: &f32| side.to_bits();
    a.as_flattened().iter().map(bits).eq(b.as_flattened().iter().map(bits))
}

#[test]
fn blocks_of_any_size_give_the_same_samples() {
    let song = &song()[..8 * BAR];
    for size in [1, 7, 48, 479, 4096] {
        let mut synthesizer = Box::<Synthesizer>::default();
        let mut samples = vec![[0.0; 2]; song.len()];
        for block in samples.chunks_mut(size) {
            synthesizer.play(block);
        }
        assert!(same(&samples, song), "blocks of {size}");
    }
    let mut synthesizer = Box::<Synthesizer>::default();
    let mut samples = Vec::new();
    while samples.len() < song.len() {
        samples.extend_from_slice(synthesizer.chunk());
    }
    assert!(same(&samples[..song.len()], song), "its own blocks");
}

/// Forwards, backwards, to the middle of a block, and past the end.
#[test]
fn seeking_gives_the_same_samples_as_playing() {
    let mut synthesizer = Box::<Synthesizer>::default();
    let cuts = show::CUTS.map(|bar| bar as usize * BAR);
    let end = SONG_LENGTH as usize - 100;
    for start in cuts.into_iter().step_by(3).chain([9 * BAR + 1, 0, 12_345, end]) {
        synthesizer.seek(start as u32);
        let mut samples = vec![[0.0; 2]; BAR / 4];
        synthesizer.play(&mut samples);
        let repeated = song().iter().cycle().skip(start);
        let expected: Vec<[f32; 2]> = repeated.take(samples.len()).copied().collect();
        assert!(same(&samples, &expected), "from {start}");
    }
}
