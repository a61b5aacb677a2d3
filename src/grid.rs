//! The musical grid on which picture and sound are laid out: 120 beats per minute, four beats per bar, 48 bars.
//!
//! At 48 kHz a beat has 24,000 samples, and at 60 frames per second 30 frames, so every beat falls on a frame.

/// Beats per minute.
pub const BEATS_PER_MINUTE: u32 = 120;

/// Beats per bar.
pub const BEATS_PER_BAR: u32 = 4;

/// The length of the show in bars.
pub const BARS: u32 = 48;

/// The length of a beat in seconds: 0.5.
pub const BEAT: f32 = 60.0 / BEATS_PER_MINUTE as f32;

/// The length of a bar in seconds: 2.
pub const BAR: f32 = BEAT * BEATS_PER_BAR as f32;

/// The length of the show in seconds: 96.
pub const SHOW_LENGTH: f32 = BAR * BARS as f32;

/// The bars at which the scenes begin, counted from 0. The last scene ends with the show.
pub const CUTS: [u32; 7] = [TITLE, MODEL, METHOD, COLONNADE, MACHINE, SWARM, FINALE];

/// The names of the scenes that begin there.
pub const NAMES: [&str; CUTS.len()] = [
    "title",
    "model",
    "method",
    "colonnade",
    "machine",
    "swarm",
    "finale",
];

/// Spheres form the title. The music is sparse.
pub const TITLE: u32 = 0;
/// The model scene. The drums come in.
pub const MODEL: u32 = 6;
/// The method is explained on the model scene.
pub const METHOD: u32 = 14;
/// The colonnade. A calm break.
pub const COLONNADE: u32 = 22;
/// The machine. The music is hard and driving.
pub const MACHINE: u32 = 30;
/// The swarm of spheres. The climax.
pub const SWARM: u32 = 36;
/// Credits and greetings. The music rings out.
pub const FINALE: u32 = 42;
