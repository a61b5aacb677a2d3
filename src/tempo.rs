//! The tempo of picture and sound. A beat is 24,000 samples at 48 kHz and 30 frames at 60 Hz, so
//! every beat falls on a frame.

/// Beats per minute.
pub const BEATS_PER_MINUTE: u32 = 120;

/// Beats per bar.
pub const BEATS_PER_BAR: u32 = 4;

/// The length of a beat in seconds: 0.5.
pub const BEAT: f32 = 60.0 / BEATS_PER_MINUTE as f32;

/// The length of a bar in seconds: 2.
pub const BAR: f32 = BEAT * BEATS_PER_BAR as f32;
