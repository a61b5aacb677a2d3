use super::RATE;
use super::song::TRACKS;
use core::f32::consts::PI;
use glam::{Vec4, vec4};

/// The meaning of a pattern's digits. Notes are MIDI numbers: 69 is 440 Hz, and an octave has 12.
pub(super) enum Notes {
    /// This note; the digit is its loudness, 1 to 15.
    Drum(u8),
    /// The chord's bass; the digit is its loudness, 1 to 15.
    Root,
    /// A note of the theme, this number of semitones down.
    Theme(u8),
    /// A note of the bar's chord, this number of semitones up: digits 1 to 4 count from its root, 5
    /// to 8 an octave higher.
    Tone(u8),
    /// The note of [`Notes::Tone`], and the three above it.
    Chord(u8),
}

pub(super) struct Instrument {
    pub notes: Notes,
    pub source: Source,
    /// The oscillators' pitches relative to the note's; the first is the lowest. The higher ones
    /// decay faster.
    pub partials: Vec4,
    /// The outermost oscillators' deviation, as a fraction of the pitch.
    pub detune: f32,
    /// The pitch's initial deviation, as a fraction of the pitch.
    pub bend: f32,
    pub modulation: Modulation,
    /// The fraction of the interval to its note that the pitch glides in each
    /// [chunk](super::CHUNK).
    pub glide: f32,
    pub envelope: Envelope,
    pub sweep: Sweep,
    /// The oscillators' factors on the cutoff.
    pub formants: Vec4,
    pub timbre: Timbre,
    /// The share of each side that the other one also plays; at 1 left and right are equal.
    pub centre: f32,
    pub effects: Effects,
}

/// The amplitudes of the oscillators and the noise, before [`LOUDNESS`].
pub(super) struct Source {
    pub saw: f32,
    pub sine: f32,
    pub noise: f32,
}

/// A sine that modulates the sine's phase.
pub(super) struct Modulation {
    /// Its initial amplitude, in turns.
    pub index: f32,
    /// Its pitch relative to the note's.
    pub ratio: f32,
}

/// Inverse time constants, in 1 / samples. The level decays while the note is held.
pub(super) struct Envelope {
    pub attack: f32,
    pub decay: f32,
    pub release: f32,
    /// The note's duration in beats.
    pub gate: f32,
}

/// The change of pitch, modulation and filter during a note.
pub(super) struct Sweep {
    /// The inverse time constant, in 1 / samples.
    pub rate: f32,
    /// The filter's cutoff frequencies, as angles: pi is the sampling rate.
    pub start: f32,
    pub end: f32,
}

pub(super) struct Timbre {
    /// The increase of the cutoff at the bar's full brightness, as a fraction.
    pub light: f32,
    /// 2 has no resonance, values towards 0 whistle.
    pub damping: f32,
    /// The fraction of high pass, 0 to 1; the rest is low pass.
    pub high: f32,
}

/// Amplitudes of the effects' inputs, and a kick's attenuation, 0 to 1.
pub(super) struct Effects {
    pub echo: f32,
    pub room: f32,
    pub duck: f32,
}

/// The factor on all amplitudes, for a soundtrack between -14 and -12 LUFS.
pub(super) const LOUDNESS: f32 = 0.47;

const fn hz(frequency: f32) -> f32 {
    frequency * PI / RATE as f32
}

const fn s(time: f32) -> f32 {
    1.0 / (time * RATE as f32)
}

pub(super) const STROKE: f32 = s(0.001);

const SILENT: Instrument = Instrument {
    notes: Notes::Theme(0),
    source: Source { saw: 0.0, sine: 0.0, noise: 0.0 },
    partials: Vec4::ONE,
    detune: 0.0,
    bend: 0.0,
    modulation: Modulation { index: 0.0, ratio: 0.0 },
    glide: 1.0,
    envelope: Envelope { attack: 0.0, decay: 0.0, release: 0.0, gate: 0.0 },
    sweep: Sweep { rate: 0.0, start: 0.0, end: 0.0 },
    formants: Vec4::ONE,
    timbre: Timbre { light: 0.0, damping: 1.4, high: 0.0 },
    centre: 0.3,
    effects: Effects { echo: 0.0, room: 0.0, duck: 0.0 },
};

const PAD: Instrument = Instrument {
    notes: Notes::Chord(24),
    source: Source { saw: 0.09, sine: 0.0, noise: 0.032 },
    detune: 0.006,
    glide: 0.03,
    envelope: Envelope { attack: s(0.6), decay: s(10.0), release: s(0.1), gate: 4.0 },
    sweep: Sweep { rate: s(1.5), start: hz(700.0), end: hz(900.0) },
    timbre: Timbre { light: 7.0, damping: 1.2, high: 0.15 },
    centre: 0.25,
    effects: Effects { echo: 0.0, room: 0.2, duck: 0.6 },
    ..SILENT
};

const HAT: Instrument = Instrument {
    notes: Notes::Drum(60),
    source: Source { saw: 0.0, sine: 0.0, noise: 0.22 },
    envelope: Envelope { attack: STROKE, decay: s(0.025), release: s(0.02), gate: 0.25 },
    sweep: Sweep { rate: s(0.02), start: hz(7000.0), end: hz(7000.0) },
    timbre: Timbre { light: 0.0, damping: 1.2, high: 1.0 },
    effects: Effects { echo: 0.0, room: 0.025, duck: 0.1 },
    ..SILENT
};

pub(super) static INSTRUMENTS: [Instrument; TRACKS] = [
    // Kick.
    Instrument {
        notes: Notes::Root,
        source: Source { saw: 0.0, sine: 0.34, noise: 0.13 },
        bend: 7.0,
        envelope: Envelope { attack: STROKE, decay: s(0.17), release: s(0.04), gate: 0.5 },
        sweep: Sweep { rate: s(0.016), start: hz(9000.0), end: hz(120.0) },
        centre: 1.0,
        effects: Effects { echo: 0.0, room: 0.01, duck: 0.0 },
        ..SILENT
    },
    // Clap.
    Instrument {
        notes: Notes::Drum(54),
        source: Source { saw: 0.0, sine: 0.12, noise: 0.3 },
        bend: 0.8,
        envelope: Envelope { attack: STROKE, decay: s(0.09), release: s(0.06), gate: 0.5 },
        sweep: Sweep { rate: s(0.02), start: hz(1100.0), end: hz(900.0) },
        timbre: Timbre { light: 0.0, damping: 0.9, high: 0.9 },
        effects: Effects { echo: 0.0, room: 0.125, duck: 0.0 },
        ..SILENT
    },
    HAT,
    // Open hat.
    Instrument {
        source: Source { saw: 0.0, sine: 0.0, noise: 0.18 },
        envelope: Envelope { attack: STROKE, decay: s(0.12), release: s(0.03), gate: 0.4 },
        sweep: Sweep { rate: s(0.02), start: hz(6000.0), end: hz(6000.0) },
        effects: Effects { echo: 0.04, ..HAT.effects },
        ..HAT
    },
    // Tom.
    Instrument {
        notes: Notes::Drum(45),
        source: Source { saw: 0.0, sine: 0.12, noise: 0.05 },
        bend: 1.5,
        envelope: Envelope { attack: STROKE, decay: s(0.18), release: s(0.06), gate: 0.7 },
        sweep: Sweep { rate: s(0.05), start: hz(4000.0), end: hz(300.0) },
        timbre: Timbre { light: 0.0, damping: 1.2, high: 0.0 },
        centre: 0.6,
        effects: Effects { echo: 0.0, room: 0.1, duck: 0.0 },
        ..SILENT
    },
    // Bass.
    Instrument {
        notes: Notes::Tone(0),
        source: Source { saw: 0.1, sine: 0.065, noise: 0.0 },
        modulation: Modulation { index: 0.1, ratio: 1.0 },
        envelope: Envelope { attack: s(0.003), decay: s(0.4), release: s(0.03), gate: 0.4 },
        sweep: Sweep { rate: s(0.1), start: hz(900.0), end: hz(160.0) },
        timbre: Timbre { light: 3.0, damping: 0.9, high: 0.0 },
        centre: 1.0,
        effects: Effects { echo: 0.0, room: 0.01, duck: 0.9 },
        ..SILENT
    },
    // Sub.
    Instrument {
        notes: Notes::Theme(36),
        source: Source { saw: 0.077, sine: 0.05, noise: 0.0 },
        envelope: Envelope { attack: s(0.05), decay: s(3.0), release: s(0.1), gate: 3.5 },
        sweep: Sweep { rate: s(1.0), start: hz(300.0), end: hz(300.0) },
        timbre: Timbre { light: 1.0, damping: 1.4, high: 0.0 },
        centre: 1.0,
        effects: Effects { echo: 0.0, room: 0.02, duck: 0.0 },
        ..SILENT
    },
    // Vowel: the formants of a dark O.
    Instrument {
        source: Source { saw: 0.185, noise: 0.24, ..PAD.source },
        sweep: Sweep { start: hz(300.0), end: hz(300.0), ..PAD.sweep },
        formants: vec4(1.0, 2.6, 2.6, 1.0),
        timbre: Timbre { light: 0.35, damping: 0.35, high: 0.22 },
        ..PAD
    },
    PAD,
    // The second pad, a little more detuned. Its chords start on another note, which swaps the
    // notes' sides in stereo.
    Instrument { detune: 0.007, ..PAD },
    // Arpeggio.
    Instrument {
        notes: Notes::Tone(24),
        source: Source { saw: 0.24, sine: 0.0, noise: 0.0 },
        detune: 0.004,
        envelope: Envelope { attack: s(0.002), decay: s(0.18), release: s(0.06), gate: 0.5 },
        sweep: Sweep { rate: s(0.07), start: hz(1800.0), end: hz(350.0) },
        timbre: Timbre { light: 6.0, damping: 0.5, high: 0.0 },
        effects: Effects { echo: 0.4, room: 0.125, duck: 0.5 },
        ..SILENT
    },
    // Strings, in unison.
    Instrument {
        source: Source { saw: 0.345, sine: 0.0, noise: 0.0 },
        detune: 0.004,
        envelope: Envelope { attack: s(0.12), decay: s(8.0), release: s(0.15), gate: 5.0 },
        sweep: Sweep { rate: s(1.0), start: hz(4000.0), end: hz(6000.0) },
        timbre: Timbre { light: 1.0, damping: 1.2, high: 0.5 },
        effects: Effects { echo: 0.0, room: 0.2, duck: 0.0 },
        ..SILENT
    },
    // Lead, in octaves.
    Instrument {
        source: Source { saw: 0.33, sine: 0.26, noise: 0.0 },
        partials: vec4(1.0, 1.0, 2.0, 2.0),
        detune: 0.005,
        glide: 0.1,
        envelope: Envelope { attack: s(0.006), decay: s(1.2), release: s(0.15), gate: 1.5 },
        sweep: Sweep { rate: s(0.4), start: hz(4000.0), end: hz(1800.0) },
        timbre: Timbre { light: 2.0, damping: 0.9, high: 0.6 },
        centre: 0.2,
        effects: Effects { echo: 0.3, room: 0.12, duck: 0.1 },
        ..SILENT
    },
    // Chime: the partials of a pipe.
    Instrument {
        source: Source { saw: 0.0, sine: 0.345, noise: 0.0 },
        partials: vec4(1.0, 2.0, 2.99, 4.17),
        detune: 0.001,
        envelope: Envelope { attack: STROKE, decay: s(0.5), release: s(0.5), gate: 4.0 },
        sweep: Sweep { rate: s(0.1), start: hz(12000.0), end: hz(6000.0) },
        centre: 0.2,
        effects: Effects { echo: 0.2, room: 0.15, duck: 0.2 },
        ..SILENT
    },
    // Marimba: a bar, tuned to double octaves.
    Instrument {
        notes: Notes::Theme(12),
        source: Source { saw: 0.0, sine: 0.29, noise: 0.05 },
        partials: vec4(1.0, 1.0, 4.0, 4.0),
        detune: 0.003,
        modulation: Modulation { index: 0.35, ratio: 4.0 },
        envelope: Envelope { attack: STROKE, decay: s(0.22), release: s(0.01), gate: 2.0 },
        sweep: Sweep { rate: s(0.03), start: hz(9000.0), end: hz(3000.0) },
        centre: 0.0,
        effects: Effects { echo: 0.2, room: 0.12, duck: 0.0 },
        ..SILENT
    },
    // Square: a modulator an octave up gives odd harmonics.
    Instrument {
        notes: Notes::Theme(12),
        source: Source { saw: 0.0, sine: 0.26, noise: 0.02 },
        detune: 0.001,
        modulation: Modulation { index: 0.35, ratio: 2.0 },
        envelope: Envelope { attack: STROKE, decay: s(0.3), release: s(0.05), gate: 0.25 },
        sweep: Sweep { rate: s(0.3), start: hz(12000.0), end: hz(9000.0) },
        centre: 0.25,
        effects: Effects { echo: 0.15, room: 0.05, duck: 0.0 },
        ..SILENT
    },
    // Pop: it rises to its note, as a bubble does.
    Instrument {
        source: Source { saw: 0.0, sine: 0.34, noise: 0.1 },
        detune: 0.003,
        bend: -0.6,
        envelope: Envelope { attack: STROKE, decay: s(0.2), release: s(0.05), gate: 1.0 },
        sweep: Sweep { rate: s(0.012), start: hz(9000.0), end: hz(6000.0) },
        centre: 0.0,
        effects: Effects { echo: 0.25, room: 0.15, duck: 0.0 },
        ..SILENT
    },
    // Riser.
    Instrument {
        notes: Notes::Drum(60),
        source: Source { saw: 0.0, sine: 0.0, noise: 0.3 },
        envelope: Envelope { attack: s(2.0), decay: s(10.0), release: s(0.02), gate: 7.5 },
        sweep: Sweep { rate: s(2.0), start: hz(150.0), end: hz(6000.0) },
        timbre: Timbre { light: 0.0, damping: 0.5, high: 0.3 },
        effects: Effects { echo: 0.02, room: 0.12, duck: 0.5 },
        ..SILENT
    },
    // Boom.
    Instrument {
        notes: Notes::Drum(33), // A1
        source: Source { saw: 0.0, sine: 0.1, noise: 0.05 },
        bend: 2.0,
        envelope: Envelope { attack: s(0.002), decay: s(0.7), release: s(0.7), gate: 4.0 },
        sweep: Sweep { rate: s(0.12), start: hz(900.0), end: hz(120.0) },
        centre: 1.0,
        effects: Effects { echo: 0.0, room: 0.05, duck: 0.0 },
        ..SILENT
    },
];
