//! The musical grid of picture and sound: 120 beats per minute, four beats per bar.
//!
//! At 48 kHz a beat has 24,000 samples, and at 60 frames per second 30 frames, so every beat falls on a frame. The
//! [scenes](crate::show) determine the number of bars and the cuts.

/// Beats per minute.
pub const BEATS_PER_MINUTE: u32 = 120;

/// Beats per bar.
pub const BEATS_PER_BAR: u32 = 4;

/// The length of a beat in seconds: 0.5.
pub const BEAT: f32 = 60.0 / BEATS_PER_MINUTE as f32;

/// The length of a bar in seconds: 2.
pub const BAR: f32 = BEAT * BEATS_PER_BAR as f32;
