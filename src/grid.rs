//! The grid that picture and sound are laid on: 120 beats a minute, four beats a bar, 48 bars.
//!
//! At 48 kHz a beat is 24,000 samples, at 60 frames a second it is 30 frames: every accent of the sound falls on a frame.

/// Beats in a minute.
pub const BEATS_PER_MINUTE: u32 = 120;

/// Beats in a bar.
pub const BEATS_PER_BAR: u32 = 4;

/// Bars of the whole show.
pub const BARS: u32 = 48;

/// Seconds of a beat: 0.5.
pub const BEAT: f32 = 60.0 / BEATS_PER_MINUTE as f32;

/// Seconds of a bar: 2.
pub const BAR: f32 = BEAT * BEATS_PER_BAR as f32;

/// Seconds of the whole show: 96.
pub const LENGTH: f32 = BAR * BARS as f32;

/// The bars at which scenes begin, counted from 0; the last one ends with the show.
pub const CUTS: [u32; 7] = [TITLE, MODEL, METHOD, COLONNADE, MACHINE, SWARM, FINALE];

/// Spheres form the title. Sparse.
pub const TITLE: u32 = 0;
/// The model scene. The beat comes in.
pub const MODEL: u32 = 6;
/// The method explained.
pub const METHOD: u32 = 14;
/// The colonnade. The break: calm.
pub const COLONNADE: u32 = 22;
/// The machine. Hard and driving.
pub const MACHINE: u32 = 30;
/// The swarm of spheres. The climax.
pub const SWARM: u32 = 36;
/// Credits and greetings. Rings out.
pub const FINALE: u32 = 42;
