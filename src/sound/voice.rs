//! An instrument's voice: four oscillators, an amplitude envelope, a sweep and a filter.

use super::instruments::{Instrument, LOUDNESS, Notes, STROKE, Sweep};
use super::{CHUNK, song};
use eightfold_tracer::maths::ROUND_TO_INTEGER;
use glam::{Vec4, Vec4Swizzles, vec4};

/// The frequency of MIDI note 0 in Hz, 69 semitones below 440.
const LOWEST: f32 = 8.175_799;

/// The twelfth root of 2.
const SEMITONE: f32 = 1.059_463_1;

/// The sum of all voices for one sample. Lanes 0 and 2 are left, 1 and 3 right.
#[derive(Clone, Copy)]
pub(super) struct Mix {
    pub dry: Vec4,
    pub echo: Vec4,
    /// The reverberation's input.
    pub room: Vec4,
    /// Noise from -1 to 1, common to all voices.
    pub noise: Vec4,
}

impl Mix {
    pub const SILENCE: Mix =
        Mix { dry: Vec4::ZERO, echo: Vec4::ZERO, room: Vec4::ZERO, noise: Vec4::ZERO };
}

/// Common settings of all voices in a chunk. All four lanes are equal.
pub(super) struct Mood {
    /// The kick's level at the start of this chunk and the next, 0 to 1.
    pub kick: Vec4,
    pub next_kick: Vec4,
    /// The brightness, 0 to 1.
    pub light: Vec4,
    /// Whether all voices rest, before a cut.
    pub rest: bool,
}

/// The state of an instrument's four oscillators, one in each lane; zero before the first note.
#[derive(Clone, Copy)]
pub(super) struct Voice {
    /// In turns from -1/2 to 1/2.
    phase: Vec4,
    /// Phases of the modulating sines, in turns.
    modulator: Vec4,
    /// In turns per sample.
    pitch: Vec4,
    target: Vec4,
    /// The filter's band-pass and low-pass integrators.
    band: Vec4,
    low: Vec4,
    level: Vec4,
    peak: Vec4,
    /// The sweep's envelope: 1 at the start of a note, falling to 0.
    sweep: Vec4,
    age: f32,
}

/// Below this level, -100 dB, voices are not computed.
const SILENCE: f32 = 1e-5;

/// The oscillators' detuning, as multiples of [`Instrument::detune`].
const DETUNES: Vec4 = vec4(1.0, -1.0, -0.4, 0.4);

impl Voice {
    pub const ZERO: Voice = Voice {
        phase: Vec4::ZERO,
        modulator: Vec4::ZERO,
        pitch: Vec4::ZERO,
        target: Vec4::ZERO,
        band: Vec4::ZERO,
        low: Vec4::ZERO,
        level: Vec4::ZERO,
        peak: Vec4::ZERO,
        sweep: Vec4::ZERO,
        age: 0.0,
    };

    /// Starts the note of a pattern's digit, 1 to 15, in a bar.
    pub fn start(&mut self, instrument: &Instrument, digit: u8, bar: u32, amplitude: f32) {
        let chord = song::chord(bar);
        let tone = |number: u8| chord[usize::from(number % 4)] + number / 4 * 12;
        let first = digit - 1;
        let mut peak = amplitude;
        let mut drum = |note| {
            peak *= f32::from(digit) / 15.0;
            [note; 4]
        };
        let notes = match instrument.notes {
            Notes::Drum(note) => drum(note),
            Notes::Root => drum(chord[0]),
            Notes::Theme(down) => [song::theme(digit, bar) - down; 4],
            Notes::Tone(up) => [tone(first) + up; 4],
            Notes::Chord(up) => [0, 1, 2, 3].map(|i| tone(first + i) + up),
        };
        // A loop is smaller than a power.
        let pitch = notes
            .map(|note| (0..note).fold(LOWEST / super::RATE as f32, |pitch, _| pitch * SEMITONE));
        let pitch = Vec4::from_array(pitch) * instrument.partials;
        self.target = pitch + pitch * DETUNES * instrument.detune;
        if instrument.envelope.attack >= STROKE {
            // So that every stroke sounds the same.
            self.phase = Vec4::ZERO;
        }
        self.peak = Vec4::splat(peak);
        self.sweep = Vec4::ONE;
        self.age = 0.0;
    }

    pub fn play(&mut self, instrument: &Instrument, mood: &Mood, mixes: &mut [Mix; CHUNK]) {
        const BEAT: f32 = (super::STEP * super::STEPS_PER_BEAT) as f32 / CHUNK as f32;
        /// The attack lasts for two time constants: the level rises to 1 - 1/e^2 of its peak.
        const ATTACK: f32 = 2.0 / CHUNK as f32;
        let Instrument { source, modulation, envelope, sweep, effects, .. } = instrument;
        self.age += 1.0;
        let (peak, rate) = if mood.rest || self.age >= envelope.gate * BEAT {
            (Vec4::ZERO, envelope.release)
        } else if self.age * envelope.attack < ATTACK {
            (self.peak, envelope.attack)
        } else {
            (Vec4::ZERO, envelope.decay)
        };
        let rate = instrument.partials * rate;
        if self.level.x + peak.x < SILENCE {
            return;
        }
        self.pitch += (self.target - self.pitch) * instrument.glide;
        let filter = Filter::new(instrument, self.sweep, mood.light);
        let mut voice = *self;
        let mut duck = 1.0 - effects.duck * mood.kick;
        let duck_slope = effects.duck * (mood.next_kick - mood.kick) * (1.0 / CHUNK as f32);
        for mix in mixes {
            voice.level += (peak - voice.level) * rate;
            voice.sweep -= voice.sweep * sweep.rate;
            let turn = voice.pitch + voice.pitch * instrument.bend * voice.sweep;
            voice.phase = wrap(voice.phase + turn);
            voice.modulator = wrap(voice.modulator + turn * modulation.ratio);
            let shift = sine(voice.modulator) * modulation.index * voice.sweep;
            let sound = saw(voice.phase, turn) * source.saw
                + sine(wrap(voice.phase + shift)) * source.sine
                + mix.noise * source.noise;
            let sound = filter.pass(instrument, sound * LOUDNESS, &mut voice) * voice.level * duck;
            let sound = sound + sound.yxwz() * instrument.centre;
            duck -= duck_slope;
            mix.dry += sound;
            mix.echo += sound * effects.echo;
            mix.room += sound * effects.room;
        }
        *self = voice;
    }
}

#[inline(always)]
fn wrap(phase: Vec4) -> Vec4 {
    phase - (phase + ROUND_TO_INTEGER - ROUND_TO_INTEGER)
}

/// Approximates the sine of an angle from -1/2 to 1/2 turns by two parabolas, with overtones below
/// -28 dB.
#[inline(always)]
fn sine(phase: Vec4) -> Vec4 {
    phase * (8.0 - phase.abs() * 16.0)
}

/// Returns a sawtooth that advances by `turn` turns per sample. Two parabolas smooth its step
/// (PolyBLEP).
#[inline(always)]
fn saw(phase: Vec4, turn: Vec4) -> Vec4 {
    let per_turn = turn.recip();
    let after = (1.0 - (0.5 + phase) * per_turn).max(Vec4::ZERO);
    let before = (1.0 - (0.5 - phase) * per_turn).max(Vec4::ZERO);
    phase + phase + after * after - before * before
}

/// The coefficients of a state-variable filter with 12 dB per octave, by the trapezoidal rule
/// (Simper, "Linear trapezoidal integrated SVF", 2011).
struct Filter {
    a1: Vec4,
    a2: Vec4,
    a3: Vec4,
}

impl Filter {
    #[inline(always)]
    fn new(instrument: &Instrument, sweep: Vec4, light: Vec4) -> Filter {
        let Sweep { start, end, .. } = instrument.sweep;
        let light = light * instrument.timbre.light + 1.0;
        let angle = (end + (start - end) * sweep) * light * instrument.formants;
        // The cutoff is at most 15 kHz. The tangent is accurate to 4 %.
        let x = angle.min(Vec4::ONE);
        let g = x / (1.0 + x * x * (-1.0 / 3.0));
        let damping = instrument.timbre.damping;
        let a1 = (1.0 + g * (g + damping)).recip();
        Filter { a1, a2: g * a1, a3: g * g * a1 }
    }

    #[inline(always)]
    fn pass(&self, instrument: &Instrument, sound: Vec4, voice: &mut Voice) -> Vec4 {
        let rest = sound - voice.low;
        let v1 = voice.band * self.a1 + rest * self.a2;
        let v2 = voice.low + voice.band * self.a2 + rest * self.a3;
        voice.band = v1 + v1 - voice.band;
        voice.low = v2 + v2 - voice.low;
        v2 + (sound - v1 * instrument.timbre.damping - v2 - v2) * instrument.timbre.high
    }
}
