//! What the picture takes from the sound.

use super::{STEPS_PER_BAR, song};
use crate::grid;
use crate::maths::exp2;

/// Where the song is, and how hard its kick has just hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pulse {
    /// The bar, from 0.
    pub bar: u32,
    /// The beats since the bar began, 0 to below 4.
    pub beat: f32,
    /// 1 where a kick begins on a beat, half of that a twelfth of a second later, and so on; 0 in a beat without one.
    pub kick: f32,
}

/// The song at `time` seconds, from 0 on; nothing hits after its end.
#[must_use]
pub fn pulse(time: f32) -> Pulse {
    /// How many times a kick gets half as strong in a beat: it is a tenth of a percent when the next one comes.
    const HALVES: f32 = 6.0;
    const STEPS_PER_BEAT: u32 = STEPS_PER_BAR / grid::BEATS_PER_BAR;
    let beats = time / grid::BEAT;
    let beat = beats as u32;
    let since = beats - beat as f32;
    let digit = song::step(song::KICK, beat * STEPS_PER_BEAT);
    Pulse {
        bar: beat / grid::BEATS_PER_BAR,
        beat: (beat % grid::BEATS_PER_BAR) as f32 + since,
        kick: f32::from(digit) / 15.0 * exp2(-HALVES * since),
    }
}
