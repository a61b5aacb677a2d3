//! `lab sound` prints the levels and writes its files.

use super::{printed, read_png};
use eightfold::show;
use eightfold::sound::{RATE, SONG_LENGTH};

#[test]
fn every_bar_has_a_row_and_files_are_whole() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name).display().to_string();
    let [wav, waveform, spectrogram] = ["song.wav", "waveform.png", "spectrogram.png"].map(file);
    let text = printed(&format!(
        "sound --wav {wav} --waveform {waveform} --spectrogram {spectrogram}"
    ));
    let rows = text.lines().filter(|line| line.starts_with("| ")).count();
    assert_eq!(rows, show::BARS as usize + 2, "{text}");
    for word in ["title", "finale", "LUFS", "of one core"] {
        assert!(text.contains(word), "{word}");
    }

    let bytes = std::fs::read(wav).unwrap();
    let number = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    assert_eq!(
        (&bytes[..4], &bytes[8..16]),
        (&b"RIFF"[..], &b"WAVEfmt "[..])
    );
    assert_eq!(number(4) as usize, bytes.len() - 8);
    assert_eq!(number(24), RATE);
    assert_eq!(bytes.len(), 58 + SONG_LENGTH as usize * 8);
    let side = |at: usize| f32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    let loudest = (58..bytes.len())
        .step_by(4)
        .map(|at| side(at).abs())
        .fold(0.0, f32::max);
    assert!((0.3..0.9).contains(&loudest), "{loudest}");

    for picture in [waveform, spectrogram] {
        let (width, pixels) = read_png(&std::fs::read(&picture).unwrap());
        assert_eq!((width, pixels.len()), (2016, 2016 * 552));
        let mut colours = pixels;
        colours.sort_unstable();
        colours.dedup();
        assert!(colours.len() >= 4, "{picture}: {} colours", colours.len());
    }
}
