//! Functions of time by which the picture follows the song's own notes: bounces, landings on chimes, bubbles.

use super::song::{self, Track};
use super::{STEPS_PER_BAR, STEPS_PER_BEAT};

/// The notes of a track before and after a moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cue {
    /// The number of notes that have started.
    pub count: u32,
    /// The latest note's digit: the loudness of a drum, 1 to 15, or a note, such as one of the [`THEME`](super::THEME), 1 to 8. 0
    /// before the first note.
    pub digit: u8,
    /// Beats since the latest note started, or since the moment from which notes are counted.
    pub since: f32,
    /// Beats until the next note, which may be in another scene; infinite if there is none.
    pub until: f32,
}

/// Returns the notes of a track around a moment, counted in beats from the start of a bar, 0 or more. Notes are counted from there.
///
/// | bars | track | notes | the picture |
/// | ---: | --- | --- | --- |
/// | 6 to 11 | [`Track::Kick`] | about two per bar | the glass ball bounces |
/// | 12 to 19 | [`Track::Square`] | bar n has the first n of the theme | a step per note |
/// | 28 to 33 | [`Track::Chime`] | crotchets, the theme three times | the ball lands on a pipe |
/// | 34 to 37 | [`Track::Pop`] | the first 1, 2, 4, 8 of the theme | a bubble divides |
/// | 38, 39 | [`Track::Pop`] | eight quavers from beat 18 of the scene | a bubble bursts |
/// | 40 to 45 | [`Track::Kick`] | three, three and two quavers | the sun moves |
/// | 46 to 51 | [`Track::Kick`] | crotchets and some quavers | a sixteenth of a turn |
/// | 46 to 49 | [`Track::Boom`] | one per bar | 1, 2, 4, 8 sectors snap |
/// | 52 to 56 | [`Track::Strings`] | the theme in minims, its last note held for five beats | |
/// | 57 | [`Track::Square`] | the theme in sixteenths from beat 21 of the scene | the squares double |
/// | 57 | [`Track::Marimba`] | the last note, at beat 23 of the scene | the end |
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
