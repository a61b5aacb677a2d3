use super::{STEPS_PER_BAR, song};
use crate::grid;

/// A position in the song, and the loudness of its kick drum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pulse {
    /// The bar, counted from 0.
    pub bar: u32,
    /// Beats since the start of the bar, 0 to below 4.
    pub beat: f32,
    /// The kick's loudness, 0 to 1, at the start of its beat, halved every twelfth of a second; 0 in a beat without one.
    pub kick: f32,
}

/// Returns the pulse at `time` seconds, from 0 up. After the end of the song there is no kick.
#[must_use]
pub fn pulse(time: f32) -> Pulse {
    /// Halvings of a kick in a beat, so that 1.6 % remain at the next.
    const HALVINGS: f32 = 6.0;
    const STEPS_PER_BEAT: u32 = STEPS_PER_BAR / grid::BEATS_PER_BAR;
    let beats = time / grid::BEAT;
    let beat = beats as u32;
    let since = beats - beat as f32;
    let digit = song::step(song::KICK, beat * STEPS_PER_BEAT);
    Pulse {
        bar: beat / grid::BEATS_PER_BAR,
        beat: (beat % grid::BEATS_PER_BAR) as f32 + since,
        kick: f32::from(digit) / 15.0 * libm::exp2f(-HALVINGS * since),
    }
}
