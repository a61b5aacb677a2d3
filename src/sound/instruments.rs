//! What each instrument sounds like.

use super::RATE;
use super::song::TRACKS;
use core::f32::consts::PI;

/// Where an instrument's notes come from. Notes are MIDI's: 69 is 440 Hz, and 12 are an octave.
pub(super) enum Notes {
    /// Always this one; digits say how loud.
    Drum(u8),
    /// Notes of the melody's scale.
    Scale,
    /// Notes of the bar's chord, from its root up, 1 to 4, then an octave higher; so many semitones up.
    Tone(u8),
    /// Four of these at once, the digit's and those above.
    Chord(u8),
}

/// An instrument's sound.
pub(super) struct Instrument {
    pub notes: Notes,
    /// How loud the sawtooth, the sine and the noise are, before [`LOUDNESS`].
    pub saw: f32,
    pub sine: f32,
    pub noise: f32,
    /// How far the outer oscillators are out of tune, as a share of the pitch.
    pub detune: f32,
    /// How far above its note the pitch begins, as a share of the pitch.
    pub bend: f32,
    /// By how much of a turn another sine shifts the sine's phase, at first.
    pub index: f32,
    /// The other sine's pitch, as a multiple.
    pub ratio: f32,
    /// How fast it gets loud: 1 / samples to 1 - 1/e.
    pub attack: f32,
    /// How fast it fades while a note is held: 1 / samples to 1/e.
    pub decay: f32,
    /// How fast it fades afterwards, likewise.
    pub release: f32,
    /// How long a note is held, in beats.
    pub gate: f32,
    /// How fast pitch, index and filter go from where they begin to where they end: 1 / samples to 1/e.
    pub sweep: f32,
    /// The filter's frequency at first, as an angle: pi for the sampling rate.
    pub from: f32,
    /// The filter's frequency in the end.
    pub to: f32,
    /// By how much light opens the filter: in full light, by 1 more than this.
    pub light: f32,
    /// The filter's damping: 2 for none of its own tone, towards 0 for a whistle.
    pub damping: f32,
    /// How much of the filter is a high pass; the rest of it is a low pass.
    pub high: f32,
    /// How much of the way to its note the pitch goes every [block](super::synthesizer::BLOCK).
    pub glide: f32,
    /// How much goes to the echo.
    pub echo: f32,
    /// How much goes to the room.
    pub room: f32,
    /// How much quieter it is on a kick.
    pub duck: f32,
}

/// How loud it all is.
pub(super) const LOUDNESS: f32 = 0.44;

/// A frequency in Hz as the filter's angle.
const fn hz(frequency: f32) -> f32 {
    frequency * PI / RATE as f32
}

/// A time in seconds as a rate.
const fn s(time: f32) -> f32 {
    1.0 / (time * RATE as f32)
}

/// No sound at all.
const SILENT: Instrument = Instrument {
    notes: Notes::Scale,
    saw: 0.0,
    sine: 0.0,
    noise: 0.0,
    detune: 0.0,
    bend: 0.0,
    index: 0.0,
    ratio: 0.0,
    attack: 0.0,
    decay: 0.0,
    release: 0.0,
    gate: 0.0,
    sweep: 0.0,
    from: 0.0,
    to: 0.0,
    light: 0.0,
    damping: 0.0,
    high: 0.0,
    glide: 1.0,
    echo: 0.0,
    room: 0.0,
    duck: 0.0,
};

/// The instruments of the song's tracks.
pub(super) static INSTRUMENTS: [Instrument; TRACKS] = [
    // Kick.
    Instrument {
        notes: Notes::Drum(33), // A1
        sine: 0.65,
        noise: 0.4,
        bend: 8.0,
        attack: s(0.001),
        decay: s(0.16),
        release: s(0.05),
        gate: 0.5,
        sweep: s(0.03),
        from: hz(9000.0),
        to: hz(120.0),
        damping: 1.4,
        room: 0.01,
        ..SILENT
    },
    // Clap.
    Instrument {
        notes: Notes::Drum(54),
        sine: 0.12,
        noise: 0.45,
        bend: 0.8,
        attack: s(0.001),
        decay: s(0.09),
        release: s(0.06),
        gate: 0.5,
        sweep: s(0.02),
        from: hz(1100.0),
        to: hz(900.0),
        damping: 0.9,
        high: 0.9,
        room: 0.125,
        ..SILENT
    },
    // Hat.
    Instrument {
        notes: Notes::Drum(60),
        noise: 0.45,
        attack: s(0.001),
        decay: s(0.025),
        release: s(0.02),
        gate: 0.25,
        sweep: s(0.02),
        from: hz(7000.0),
        to: hz(7000.0),
        damping: 1.2,
        high: 1.0,
        room: 0.025,
        duck: 0.1,
        ..SILENT
    },
    // Open hat.
    Instrument {
        notes: Notes::Drum(60),
        noise: 0.28,
        attack: s(0.001),
        decay: s(0.12),
        release: s(0.03),
        gate: 0.4,
        sweep: s(0.02),
        from: hz(6000.0),
        to: hz(6000.0),
        damping: 1.2,
        high: 1.0,
        echo: 0.04,
        room: 0.025,
        duck: 0.1,
        ..SILENT
    },
    // Bass.
    Instrument {
        notes: Notes::Tone(0),
        saw: 0.3,
        sine: 0.2,
        index: 0.1,
        ratio: 1.0,
        attack: s(0.003),
        decay: s(0.4),
        release: s(0.05),
        gate: 0.4,
        sweep: s(0.1),
        from: hz(900.0),
        to: hz(180.0),
        light: 3.0,
        damping: 0.9,
        room: 0.01,
        duck: 0.7,
        ..SILENT
    },
    // Pad.
    Instrument {
        notes: Notes::Chord(24),
        saw: 0.1,
        noise: 0.002,
        detune: 0.006,
        attack: s(0.6),
        decay: s(10.0),
        release: s(0.5),
        gate: 4.0,
        sweep: s(1.5),
        from: hz(500.0),
        to: hz(700.0),
        light: 7.0,
        damping: 1.2,
        glide: 0.03,
        room: 0.2,
        duck: 0.6,
        ..SILENT
    },
    // The same, a little more out of tune, with its notes to other sides.
    Instrument {
        notes: Notes::Chord(24),
        saw: 0.1,
        noise: 0.002,
        detune: 0.007,
        attack: s(0.6),
        decay: s(10.0),
        release: s(0.5),
        gate: 4.0,
        sweep: s(1.5),
        from: hz(500.0),
        to: hz(700.0),
        light: 7.0,
        damping: 1.2,
        glide: 0.03,
        room: 0.2,
        duck: 0.6,
        ..SILENT
    },
    // Arpeggio.
    Instrument {
        notes: Notes::Tone(24),
        saw: 0.12,
        detune: 0.004,
        attack: s(0.002),
        decay: s(0.18),
        release: s(0.1),
        gate: 0.5,
        sweep: s(0.07),
        from: hz(1800.0),
        to: hz(350.0),
        light: 6.0,
        damping: 0.5,
        echo: 0.45,
        room: 0.125,
        duck: 0.5,
        ..SILENT
    },
    // Melody.
    Instrument {
        notes: Notes::Scale,
        saw: 0.11,
        sine: 0.03,
        detune: 0.006,
        attack: s(0.015),
        decay: s(1.2),
        release: s(0.25),
        gate: 1.5,
        sweep: s(0.4),
        from: hz(3000.0),
        to: hz(1400.0),
        light: 2.0,
        damping: 0.9,
        glide: 0.04,
        echo: 0.4,
        room: 0.15,
        duck: 0.3,
        ..SILENT
    },
    // Bell.
    Instrument {
        notes: Notes::Tone(36),
        sine: 0.1,
        detune: 0.001,
        index: 0.25,
        ratio: 3.5,
        attack: s(0.002),
        decay: s(0.6),
        release: s(0.6),
        gate: 2.0,
        sweep: s(0.25),
        from: hz(8000.0),
        to: hz(4000.0),
        light: 0.5,
        damping: 1.4,
        echo: 0.4,
        room: 0.25,
        duck: 0.3,
        ..SILENT
    },
    // Stabs.
    Instrument {
        notes: Notes::Chord(24),
        saw: 0.25,
        detune: 0.008,
        attack: s(0.003),
        decay: s(0.16),
        release: s(0.08),
        gate: 0.35,
        sweep: s(0.1),
        from: hz(3000.0),
        to: hz(500.0),
        light: 2.0,
        damping: 0.7,
        echo: 0.25,
        room: 0.1,
        duck: 0.5,
        ..SILENT
    },
    // Swells.
    Instrument {
        notes: Notes::Drum(60),
        noise: 0.18,
        attack: s(2.0),
        decay: s(10.0),
        release: s(0.6),
        gate: 8.0,
        sweep: s(2.0),
        from: hz(150.0),
        to: hz(6000.0),
        damping: 0.5,
        high: 0.3,
        echo: 0.1,
        room: 0.2,
        duck: 0.5,
        ..SILENT
    },
    // Boom.
    Instrument {
        notes: Notes::Drum(33), // A1
        sine: 0.32,
        noise: 0.05,
        bend: 2.0,
        attack: s(0.002),
        decay: s(0.7),
        release: s(0.7),
        gate: 4.0,
        sweep: s(0.12),
        from: hz(900.0),
        to: hz(120.0),
        damping: 1.4,
        room: 0.2,
        ..SILENT
    },
];
