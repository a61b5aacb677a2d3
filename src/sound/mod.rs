//! The soundtrack: a song and its synthesizer, in stereo at 48 kHz. A sample depends only on its
//! position in the song.

mod cue;
mod instruments;
mod song;
mod space;
mod synthesizer;
#[cfg(test)]
mod tests;
mod voice;

pub use cue::{Cue, cue};
pub use song::{THEME, Track};
pub use synthesizer::Synthesizer;

use crate::tempo;

/// Samples per second and channel.
pub const RATE: u32 = 48_000;

/// A sixteenth, the song's shortest step, in samples: 6,000.
pub const STEP: u32 = RATE * 60 / tempo::BEATS_PER_MINUTE / STEPS_PER_BEAT;

/// Samples in a millisecond. Slow parameters, such as the filters', are updated once per chunk.
const CHUNK: usize = 48;

/// Sixteenths in a bar.
pub const STEPS_PER_BAR: u32 = 16;

const STEPS_PER_BEAT: u32 = STEPS_PER_BAR / tempo::BEATS_PER_BAR;

/// The song's length in bars.
pub const BARS: u32 = song::BARS as u32;

/// The song's length in samples.
pub const SONG_LENGTH: u32 = STEP * STEPS_PER_BAR * BARS;
