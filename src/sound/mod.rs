//! The soundtrack: a song and the synthesizer that plays it, 48 kHz stereo.
//!
//! | what | module |
//! | --- | --- |
//! | patterns, arrangement, harmony | `song` |
//! | what each instrument sounds like | `instruments` |
//! | an instrument's oscillators, envelopes, filter | `voice` |
//! | echo and room, in buffers of fixed size | `space` |
//! | all of them together, block by block | [`Synthesizer`] |
//! | what the picture takes from the sound | [`pulse()`] |
//!
//! A sample is a function of the song and its position, whichever blocks it is asked for in.

mod instruments;
mod pulse;
mod song;
mod space;
mod synthesizer;
mod voice;

pub use pulse::{Pulse, pulse};
pub use synthesizer::Synthesizer;

use crate::grid;

/// Samples in a second, for each ear.
pub const RATE: u32 = 48_000;

/// Samples of a sixteenth, the song's shortest step: 6,000.
pub const STEP: u32 = RATE * 60 / grid::BEATS_PER_MINUTE / (STEPS_PER_BAR / grid::BEATS_PER_BAR);

/// Sixteenths of a bar.
const STEPS_PER_BAR: u32 = 16;

/// Samples of the whole song: 96 s.
pub const LENGTH: u32 = STEP * STEPS_PER_BAR * grid::BARS;
