//! A voice: four oscillators, two envelopes, a filter.

use super::instruments::{Instrument, LOUDNESS, Notes};
use super::song;
use super::synthesizer::BLOCK;
use crate::maths::{ROUND_TO_INTEGER, exp2};
use glam::{Vec4, vec4};

/// Sums of what voices play, for one sample. Lanes 0 and 2 are to the left, 1 and 3 to the right.
#[derive(Clone, Copy)]
pub(super) struct Sum {
    pub dry: Vec4,
    pub echo: Vec4,
    pub room: Vec4,
    /// Noise for all voices, -1 to 1.
    pub noise: [f32; 4],
}

impl Sum {
    pub const SILENCE: Sum = Sum {
        dry: Vec4::ZERO,
        echo: Vec4::ZERO,
        room: Vec4::ZERO,
        noise: [0.0; 4],
    };
}

/// What all voices follow in a block.
pub(super) struct Mood {
    /// How loud the kick is where the block begins, 0 to 1, and where the next one does.
    pub kick: Vec4,
    pub next_kick: Vec4,
    /// How bright it is, 0 to 1.
    pub light: Vec4,
}

/// The state of an instrument: all zero before its first note.
///
/// What is one number is in all four lanes too.
#[derive(Clone, Copy)]
pub(super) struct Voice {
    /// Where the oscillators are, in turns from -1/2 to 1/2.
    phase: Vec4,
    /// Where those are that shift the phase of the sines.
    shift: Vec4,
    /// Turns a sample, and what they glide to.
    pitch: Vec4,
    goal: Vec4,
    /// The filter's two memories.
    band: Vec4,
    low: Vec4,
    level: Vec4,
    /// What the level rises to.
    peak: Vec4,
    /// 1 where a note begins, falling to 0.
    sweep: Vec4,
    /// Blocks since the note began.
    age: f32,
}

/// Quieter than this is silent: -100 dB.
const SILENCE: f32 = 1e-5;

/// How the oscillators are out of tune, in parts of the outer ones'.
const DETUNES: Vec4 = vec4(1.0, -1.0, -0.4, 0.4);

impl Voice {
    pub const ZERO: Voice = Voice {
        phase: Vec4::ZERO,
        shift: Vec4::ZERO,
        pitch: Vec4::ZERO,
        goal: Vec4::ZERO,
        band: Vec4::ZERO,
        low: Vec4::ZERO,
        level: Vec4::ZERO,
        peak: Vec4::ZERO,
        sweep: Vec4::ZERO,
        age: 0.0,
    };

    /// Begins a note: a pattern's digit, 1 to 15, in a bar's chord.
    pub fn begin(&mut self, instrument: &Instrument, digit: u8, chord: [u8; 4]) {
        let tone = |number: u8| chord[usize::from(number % 4)] + number / 4 * 12;
        let first = digit - 1;
        let notes = match instrument.notes {
            Notes::Drum(note) => [note; 4],
            Notes::Scale => [song::scale(digit); 4],
            Notes::Tone(up) => [tone(first) + up; 4],
            Notes::Chord(up) => [0, 1, 2, 3].map(|i| tone(first + i) + up),
        };
        // MIDI's note 69 is 440 Hz.
        let pitch =
            notes.map(|note| exp2((f32::from(note) - 69.0) / 12.0) * (440.0 / super::RATE as f32));
        let pitch = Vec4::from_array(pitch);
        self.goal = pitch + pitch * DETUNES * instrument.detune;
        let mut peak = 1.0;
        if let Notes::Drum(_) = instrument.notes {
            peak = f32::from(digit) / 15.0;
            // Every hit sounds the same.
            self.phase = Vec4::ZERO;
        }
        self.peak = Vec4::splat(peak);
        self.sweep = Vec4::ONE;
        self.age = 0.0;
    }

    /// Adds a block.
    pub fn play(&mut self, instrument: &Instrument, mood: &Mood, sums: &mut [Sum; BLOCK]) {
        /// Blocks of a beat.
        const BEAT: f32 = (super::STEP * 4) as f32 / BLOCK as f32;
        /// Of the way to its peak a level rises 1 - 1/e^2.
        const RISEN: f32 = 2.0 / BLOCK as f32;
        self.age += 1.0;
        let (peak, rate) = if self.age * instrument.attack < RISEN {
            (self.peak, instrument.attack)
        } else if self.age < instrument.gate * BEAT {
            (Vec4::ZERO, instrument.decay)
        } else {
            (Vec4::ZERO, instrument.release)
        };
        if self.level.x + peak.x < SILENCE {
            return;
        }
        self.pitch += (self.goal - self.pitch) * instrument.glide;
        let filter = Filter::new(instrument, self.sweep, mood.light);
        let mut voice = *self;
        let mut duck = 1.0 - instrument.duck * mood.kick;
        let duck_slope = instrument.duck * (mood.next_kick - mood.kick) * (1.0 / BLOCK as f32);
        for sum in sums {
            voice.level += (peak - voice.level) * rate;
            voice.sweep -= voice.sweep * instrument.sweep;
            let turn = voice.pitch + voice.pitch * instrument.bend * voice.sweep;
            voice.phase = wrap(voice.phase + turn);
            voice.shift = wrap(voice.shift + turn * instrument.ratio);
            let shift = sine(voice.shift) * instrument.index * voice.sweep;
            let sound = saw(voice.phase, turn) * instrument.saw
                + sine(wrap(voice.phase + shift)) * instrument.sine
                + Vec4::from_array(sum.noise) * instrument.noise;
            let sound = filter.pass(instrument, sound * LOUDNESS, &mut voice) * voice.level * duck;
            duck -= duck_slope;
            sum.dry += sound;
            sum.echo += sound * instrument.echo;
            sum.room += sound * instrument.room;
        }
        *self = voice;
    }
}

/// A phase as turns from -1/2 to 1/2.
#[inline(always)]
fn wrap(phase: Vec4) -> Vec4 {
    phase - (phase + ROUND_TO_INTEGER - ROUND_TO_INTEGER)
}

/// Nearly a sine of an angle in turns from -1/2 to 1/2: two parabolas, all overtones below -28 dB.
#[inline(always)]
fn sine(phase: Vec4) -> Vec4 {
    phase * (8.0 - phase.abs() * 16.0)
}

/// A sawtooth that goes up by so many turns a sample. Its step is two parabolas (PolyBLEP), which keeps most of what
/// would alias out of it.
#[inline(always)]
fn saw(phase: Vec4, turn: Vec4) -> Vec4 {
    let per_turn = turn.recip();
    let after = (1.0 - (0.5 + phase) * per_turn).max(Vec4::ZERO);
    let before = (1.0 - (0.5 - phase) * per_turn).max(Vec4::ZERO);
    phase + phase + after * after - before * before
}

/// A state-variable filter, 12 dB an octave, by trapezoids (Simper, "Linear trapezoidal integrated SVF", 2011).
struct Filter {
    a1: Vec4,
    a2: Vec4,
    a3: Vec4,
}

impl Filter {
    #[inline(always)]
    fn new(instrument: &Instrument, sweep: Vec4, light: Vec4) -> Filter {
        let to = instrument.to;
        let angle = (to + (instrument.from - to) * sweep) * (light * instrument.light + 1.0);
        // Up to 15 kHz; the tangent to within 4 %.
        let x = angle.min(Vec4::ONE);
        let g = x / (1.0 + x * x * (-1.0 / 3.0));
        let damping = instrument.damping;
        let a1 = (1.0 + g * (g + damping)).recip();
        Filter {
            a1,
            a2: g * a1,
            a3: g * g * a1,
        }
    }

    #[inline(always)]
    fn pass(&self, instrument: &Instrument, sound: Vec4, voice: &mut Voice) -> Vec4 {
        let rest = sound - voice.low;
        let v1 = voice.band * self.a1 + rest * self.a2;
        let v2 = voice.low + voice.band * self.a2 + rest * self.a3;
        voice.band = v1 + v1 - voice.band;
        voice.low = v2 + v2 - voice.low;
        v2 + (sound - v1 * instrument.damping - v2 - v2) * instrument.high
    }
}
