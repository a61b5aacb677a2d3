use super::{cues, song};
use eightfold::show::{self, tempo};
use eightfold::sound::{RATE, Track};

const FRAME: usize = RATE as usize / 1000;

/// Milliseconds before and after an onset whose energies are compared.
const SPAN: usize = 8;

/// Returns the treble's energy per millisecond. A kick starts with treble; its bass rises over 50
/// ms.
fn energies() -> Vec<f32> {
    let steps = song().windows(2).map(|pair| {
        let step = [0, 1].map(|side| pair[1][side] - pair[0][side]);
        step[0] * step[0] + step[1] * step[1]
    });
    let steps: Vec<f32> = steps.collect();
    steps.chunks(FRAME).map(|frame| frame.iter().sum()).collect()
}

/// Checks the notes of a track that are not quieter than `digit`. Returns their number.
fn check(track: Track, bars: [u32; 2], digit: u8) -> usize {
    let energies = energies();
    let rise = |at: usize| {
        let sum = |from: usize| energies[from..from + SPAN].iter().sum::<f32>();
        sum(at) - sum(at - SPAN)
    };
    let notes = cues::notes(track, bars[0], bars[1] - bars[0]);
    let notes: Vec<_> = notes.into_iter().filter(|note| note.1 >= digit).collect();
    for (beat, _) in &notes {
        let time = tempo::BAR * bars[0] as f32 + tempo::BEAT * beat;
        let at = (time * 1000.0) as usize;
        let steepest = (at - 60..at + 60).max_by(|&a, &b| rise(a).total_cmp(&rise(b)));
        let onset = steepest.expect("some milliseconds");
        assert!(onset.abs_diff(at) <= 10, "{track:?}, beat {beat}: {onset} ms, not {at}");
    }
    notes.len()
}

#[test]
fn notes_are_heard_within_10_ms_of_their_beats() {
    let kicks = check(Track::Kick, [0, show::BARS], 11);
    assert!(kicks > 80, "{kicks} kicks");
    // The landings, the bubbles, the steps of the method.
    let tracks =
        [(Track::Chime, [28, 34], 24), (Track::Pop, [34, 40], 23), (Track::Square, [12, 20], 36)];
    for (track, bars, count) in tracks {
        assert_eq!(check(track, bars, 1), count, "{track:?}");
    }
}
