//! Functions of time by which the picture follows the song's own notes: bounces, landings on
//! chimes, bubbles.

use super::song::{self, Track};
use super::{STEPS_PER_BAR, STEPS_PER_BEAT};

/// The notes of a track around a moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cue {
    /// The number of notes that have started.
    pub count: u32,
    /// The latest note's digit: the loudness of a drum, 1 to 15, or a note of the
    /// [`THEME`](super::THEME), 1 to 8. 0 before the first note.
    pub digit: u8,
    /// Beats since the latest note, or since the moment from which notes are counted.
    pub since: f32,
    /// Beats until the next note, infinite if there is none.
    pub until: f32,
}

/// Returns the notes of a track around a moment, in `beats` from the start of a bar, 0 or more.
/// Notes are counted from there.
#[must_use]
pub fn cue(track: Track, bar: u32, beats: f32) -> Cue {
    let mut cue = Cue { count: 0, digit: 0, since: beats, until: f32::INFINITY };
    let first = bar * STEPS_PER_BAR;
    for step in first..song::BARS as u32 * STEPS_PER_BAR {
        let digit = song::digit(track as usize, step);
        if digit > 0 {
            let since = beats - (step - first) as f32 / STEPS_PER_BEAT as f32;
            if since < 0.0 {
                cue.until = -since;
                break;
            }
            cue = Cue { count: cue.count + 1, digit, since, ..cue };
        }
    }
    cue
}
