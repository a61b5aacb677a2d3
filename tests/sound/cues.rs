use eightfold::show::tempo;
use eightfold::sound::{Cue, Track, cue};

/// Returns the starts of a track's notes, in beats from the start of `bar`, and their digits.
pub fn notes(track: Track, bar: u32, bars: u32) -> Vec<(f32, u8)> {
    let end = (bars * tempo::BEATS_PER_BAR) as f32;
    let (mut notes, mut now) = (Vec::new(), cue(track, bar, 0.0));
    loop {
        let at = if now.count > 0 { 0.0 } else { now.until };
        let last = notes.last().map_or(at, |&(beat, _)| beat + now.until);
        if last >= end {
            return notes;
        }
        now = cue(track, bar, last);
        assert_eq!((now.count as usize, now.since), (notes.len() + 1, 0.0));
        notes.push((last, now.digit));
    }
}

fn theme(from: f32, spacing: f32, count: u8) -> Vec<(f32, u8)> {
    (0..count).map(|i| (from + spacing * f32::from(i), i % 8 + 1)).collect()
}

#[test]
fn chimes_are_struck_24_times_on_crotchets() {
    assert_eq!(notes(Track::Chime, 28, 6), theme(0.0, 1.0, 24));
    let after = cue(Track::Chime, 28, 8.25);
    assert_eq!(after, Cue { count: 9, digit: 1, since: 0.25, until: 0.75 });
}

#[test]
fn method_has_a_note_more_in_each_bar() {
    for bar in 0..7 {
        assert_eq!(notes(Track::Square, 12 + bar, 1), theme(0.0, 0.5, bar as u8 + 1));
    }
    // The last bar leaves its last quaver to the echoes.
    let mut all = theme(0.0, 0.5, 6);
    all.extend([(2.75, 7), (3.0, 8)]);
    assert_eq!(notes(Track::Square, 19, 1), all);
}

#[test]
fn bubbles_double_in_each_bar_and_pop_on_quavers() {
    for (bar, spacing) in [4.0, 2.0, 1.0, 0.5].into_iter().enumerate() {
        assert_eq!(notes(Track::Pop, 34 + bar as u32, 1), theme(0.0, spacing, 1 << bar));
    }
    assert_eq!(notes(Track::Pop, 38, 2), theme(2.0, 0.5, 8));
    assert_eq!(notes(Track::Marimba, 38, 2), theme(0.0, 0.5, 8));
}

#[test]
fn finale_ends_on_sixteenths_and_a_last_note() {
    let mut minims = theme(0.0, 2.0, 8);
    minims.push((16.0, 8));
    assert_eq!(notes(Track::Strings, 52, 6), minims);
    assert_eq!(notes(Track::Square, 52, 6), theme(21.0, 0.25, 8));
    assert_eq!(notes(Track::Marimba, 52, 6), [(23.0, 8)]);
    assert_eq!(cue(Track::Marimba, 52, 23.0).until, f32::INFINITY);
}

/// The kicks of a bar are three, three and two quavers apart. The last bar has two, since it rests
/// before the cut.
#[test]
fn sun_moves_17_times() {
    let moves: Vec<f32> = notes(Track::Kick, 40, 6).iter().map(|&(beat, _)| beat).collect();
    let expected = (0..6).flat_map(|bar| [0.0, 1.5, 3.0].map(|beat| 4.0 * bar as f32 + beat));
    assert!(expected.take(17).eq(moves));
}
