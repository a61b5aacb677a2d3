use super::song;
use eightfold::show::{self, grid};
use eightfold::sound::{RATE, Track, cue};

const FRAME: usize = RATE as usize / 1000;

/// Milliseconds before and after an onset whose energies are compared.
const SPAN: usize = 8;

/// Returns the treble's energy per millisecond, by differences of samples. A kick starts with treble; its bass rises over 50 ms.
fn energies() -> Vec<f32> {
    let steps = song().windows(2).map(|pair| {
        let step = [0, 1].map(|side| pair[1][side] - pair[0][side]);
        step[0] * step[0] + step[1] * step[1]
    });
    let steps: Vec<f32> = steps.collect();
    steps.chunks(FRAME).map(|frame| frame.iter().sum()).collect()
}

#[test]
fn kicks_are_heard_within_10_ms_of_their_beats() {
    let energies = energies();
    let rise = |at: usize| {
        let sum = |from: usize| energies[from..from + SPAN].iter().sum::<f32>();
        sum(at) - sum(at - SPAN)
    };
    let mut kicks = 0;
    for beat in 0..show::BARS * grid::BEATS_PER_BAR {
        let kick = cue(Track::Kick, beat / 4, (beat % 4) as f32);
        if kick.since > 0.0 || kick.digit < 15 {
            continue;
        }
        kicks += 1;
        let at = (grid::BEAT * beat as f32 * 1000.0) as usize;
        let steepest = (at - 60..at + 60).max_by(|&a, &b| rise(a).total_cmp(&rise(b)));
        let onset = steepest.expect("some milliseconds");
        assert!(onset.abs_diff(at) <= 10, "beat {beat}: {onset} ms, not {at}");
    }
    assert!(kicks > 100, "{kicks} kicks");
}
