//! The kicks that the picture follows are those of the sound.

use super::song;
use eightfold::show::{self, grid};
use eightfold::sound::{RATE, pulse};

/// The samples of a millisecond, over which energy is summed.
const FRAME: usize = RATE as usize / 1000;

/// The energy of the treble in each millisecond: of the differences between samples. A hit starts with treble; the bass of a kick
/// rises over 50 ms.
fn energies() -> Vec<f32> {
    let song = song();
    let energy = |frame: usize| {
        let at = (frame * FRAME).max(1)..(frame + 1) * FRAME;
        at.map(|i| {
            (0..2)
                .map(|side| (song[i][side] - song[i - 1][side]).powi(2))
                .sum::<f32>()
        })
        .sum()
    };
    (0..song.len() / FRAME).map(energy).collect()
}

/// The time, in ms, of the steepest rise of energy between two times: the mean over 8 ms after it, relative to 8 ms before.
fn steepest(energies: &[f32], from: usize, to: usize) -> usize {
    const SPAN: usize = 8;
    let rise = |at: usize| {
        let sum = |from: usize| energies[from..from + SPAN].iter().sum::<f32>();
        sum(at) - sum(at - SPAN)
    };
    (from..to)
        .max_by(|&a, &b| rise(a).total_cmp(&rise(b)))
        .unwrap()
}

#[test]
fn a_kick_is_heard_where_the_picture_has_one() {
    let energies = energies();
    let mut kicks = 0;
    let beats = show::BARS * grid::BEATS_PER_BAR;
    for beat in 0..beats {
        let time = grid::BEAT * beat as f32;
        if pulse(time).kick < 0.9 {
            continue;
        }
        kicks += 1;
        let at = (time * 1000.0) as usize;
        let onset = steepest(&energies, at - 60, at + 60);
        assert!(
            onset.abs_diff(at) <= 10,
            "beat {beat}: {onset} ms, not {at}"
        );
    }
    assert!(kicks > 100, "{kicks} kicks");
}

#[test]
fn the_pulse_counts_bars_and_beats() {
    for (time, bar, beat) in [
        (0.0, 0, 0.0),
        (1.75, 0, 3.5),
        (2.0, 1, 0.0),
        (95.5, 47, 3.0),
    ] {
        let pulse = pulse(time);
        assert_eq!((pulse.bar, pulse.beat), (bar, beat), "{time} s");
    }
}

#[test]
fn the_pulse_of_a_kick_fades_until_the_next() {
    let start = grid::BAR * show::cut("model") as f32;
    assert_eq!(pulse(start).kick, 1.0);
    let mut last = 1.0;
    for i in 1..30 {
        let kick = pulse(start + grid::BEAT * i as f32 / 30.0).kick;
        assert!(kick < last, "{i}");
        last = kick;
    }
    assert!(last < 0.03, "{last}");
    assert_eq!(pulse(grid::BAR * show::cut("colonnade") as f32).kick, 0.0);
    assert_eq!(pulse(0.0).kick, 0.0);
}
