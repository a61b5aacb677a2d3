//! What each instrument sounds like: a table of numbers.

use super::{exp2, song::TRACKS};
use core::cell::Cell;
use glam::Vec4;

// Where an instrument's notes come from.

/// One note; digits say how loud.
pub(super) const DRUM: u8 = 0;
/// Notes of the melody's scale.
pub(super) const SCALE: u8 = 1 << 6;
/// Notes of the bar's chord, from its root up: 1 to 4, then an octave higher.
pub(super) const TONE: u8 = 2 << 6;
/// Four of these at once, the digit's and those above.
pub(super) const CHORD: u8 = 3 << 6;
/// All of that; the rest is what is added in semitones, for a drum its note.
pub(super) const KINDS: u8 = 3 << 6;

/// The notes of each instrument.
pub(super) static NOTES: [u8; TRACKS] = [
    DRUM | 33, // kick: A1
    DRUM | 54,
    DRUM | 60,
    DRUM | 60,
    TONE,
    CHORD | 24,
    CHORD | 24,
    TONE | 24,
    SCALE,
    TONE | 36,
    CHORD | 24,
    DRUM | 60,
    DRUM | 33, // boom: A1
];

// The rows of `TABLE`.

/// How loud the sawtooth is.
pub(super) const SAW: usize = 0;
/// How loud the sine is.
pub(super) const SINE: usize = 1;
/// How loud the noise is.
pub(super) const NOISE: usize = 2;
/// How far the outer oscillators are out of tune, as a share of the pitch.
pub(super) const DETUNE: usize = 3;
/// How far above its note the pitch begins, as a share of the pitch.
pub(super) const BEND: usize = 4;
/// By how much of a turn another sine shifts the sine's phase, at first.
pub(super) const INDEX: usize = 5;
/// The other sine's pitch, as a multiple.
pub(super) const RATIO: usize = 6;
/// How fast it gets loud: 1 / samples to 1 - 1/e.
pub(super) const ATTACK: usize = 7;
/// How fast it fades while a note is held: 1 / samples to 1/e.
pub(super) const DECAY: usize = 8;
/// How fast it fades afterwards, likewise.
pub(super) const RELEASE: usize = 9;
/// How long a note is held, in beats.
pub(super) const GATE: usize = 10;
/// How fast pitch, index and filter go from where they begin to where they end: 1 / samples to 1/e.
pub(super) const SWEEP: usize = 11;
/// The filter's frequency at first, as an angle: pi for the sampling rate.
pub(super) const FROM: usize = 12;
/// The filter's frequency in the end.
pub(super) const TO: usize = 13;
/// By how much light opens the filter: in full light, by 1 more than this.
pub(super) const LIGHT: usize = 14;
/// The filter's damping: 2 for none of its own tone, towards 0 for a whistle.
pub(super) const DAMPING: usize = 15;
/// How much of the filter is a high pass; the rest of it is a low pass.
pub(super) const HIGH: usize = 16;
/// How much of the way to its note the pitch goes every [block](super::synthesizer::BLOCK).
pub(super) const GLIDE: usize = 17;
/// How much goes to the echo.
pub(super) const ECHO: usize = 18;
/// How much goes to the room.
pub(super) const ROOM: usize = 19;
/// How much quieter it is on a kick.
pub(super) const DUCK: usize = 20;

/// Numbers of an instrument.
const NUMBERS: usize = 21;

/// An instrument's numbers, by the names above.
///
/// Each is in all four lanes, and a cell, of which the compiler can't know that it stays as it is while sound is summed
/// up: so the voice's loop takes them from here, and does not carry twenty copies around. That is a third of its code.
pub(super) type Instrument = [Cell<Vec4>; NUMBERS];

/// A frequency in Hz as the filter's angle.
const fn hz(frequency: f32) -> f32 {
    frequency * core::f32::consts::PI / super::RATE as f32
}

/// A time in seconds as a rate.
const fn s(time: f32) -> f32 {
    1.0 / (time * super::RATE as f32)
}

#[rustfmt::skip]
const TABLE: [[f32; TRACKS]; NUMBERS] = [
    //          kick       clap       hat       open      bass      pad       pad       arp       melody    bell      stab       swell      boom
    /* saw   */ [0.0      , 0.0      , 0.0      , 0.0      , 0.30     , 0.10     , 0.10     , 0.12     , 0.11     , 0.0      , 0.25     , 0.0      , 0.0],
    /* sine  */ [0.65     , 0.12     , 0.0      , 0.0      , 0.20     , 0.0      , 0.0      , 0.0      , 0.03     , 0.10     , 0.0      , 0.0      , 0.32],
    /* noise */ [0.40     , 0.45     , 0.45     , 0.28     , 0.0      , 0.002    , 0.002    , 0.0      , 0.0      , 0.0      , 0.0      , 0.18     , 0.05],
    /* detune*/ [0.0      , 0.0      , 0.0      , 0.0      , 0.0      , 0.006    , 0.007    , 0.004    , 0.006    , 0.001    , 0.008    , 0.0      , 0.0],
    /* bend  */ [8.0      , 0.8      , 0.0      , 0.0      , 0.0      , 0.0      , 0.0      , 0.0      , 0.0      , 0.0      , 0.0      , 0.0      , 2.0],
    /* index */ [0.0      , 0.0      , 0.0      , 0.0      , 0.10     , 0.0      , 0.0      , 0.0      , 0.0      , 0.25     , 0.0      , 0.0      , 0.0],
    /* ratio */ [0.0      , 0.0      , 0.0      , 0.0      , 1.0      , 0.0      , 0.0      , 0.0      , 0.0      , 3.5      , 0.0      , 0.0      , 0.0],
    /* attack*/ [s(0.001) , s(0.001) , s(0.001) , s(0.001) , s(0.003) , s(0.6)   , s(0.6)   , s(0.002) , s(0.015) , s(0.002) , s(0.003) , s(2.0)   , s(0.002)],
    /* decay */ [s(0.16)  , s(0.09)  , s(0.025) , s(0.12)  , s(0.4)   , s(10.)   , s(10.)   , s(0.18)  , s(1.2)   , s(0.6)   , s(0.16)  , s(10.)   , s(0.7)],
    /* rel.  */ [s(0.05)  , s(0.06)  , s(0.02)  , s(0.03)  , s(0.05)  , s(0.5)   , s(0.5)   , s(0.10)  , s(0.25)  , s(0.6)   , s(0.08)  , s(0.6)   , s(0.7)],
    /* gate  */ [0.5      , 0.5      , 0.25     , 0.4      , 0.4      , 4.0      , 4.0      , 0.5      , 1.5      , 2.0      , 0.35     , 8.0      , 4.0],
    /* sweep */ [s(0.03)  , s(0.02)  , s(0.02)  , s(0.02)  , s(0.10)  , s(1.5)   , s(1.5)   , s(0.07)  , s(0.4)   , s(0.25)  , s(0.10)  , s(2.0)   , s(0.12)],
    /* from  */ [hz(9e3)  , hz(1.1e3), hz(7e3)  , hz(6e3)  , hz(900.) , hz(500.) , hz(500.) , hz(1.8e3), hz(3e3)  , hz(8e3)  , hz(3e3)  , hz(150.) , hz(900.)],
    /* to    */ [hz(120.) , hz(900.) , hz(7e3)  , hz(6e3)  , hz(180.) , hz(700.) , hz(700.) , hz(350.) , hz(1.4e3), hz(4e3)  , hz(500.) , hz(6e3)  , hz(120.)],
    /* light */ [0.0      , 0.0      , 0.0      , 0.0      , 3.0      , 7.0      , 7.0      , 6.0      , 2.0      , 0.5      , 2.0      , 0.0      , 0.0],
    /* damp. */ [1.4      , 0.9      , 1.2      , 1.2      , 0.9      , 1.2      , 1.2      , 0.5      , 0.9      , 1.4      , 0.7      , 0.5      , 1.4],
    /* high  */ [0.0      , 0.9      , 1.0      , 1.0      , 0.0      , 0.0      , 0.0      , 0.0      , 0.0      , 0.0      , 0.0      , 0.3      , 0.0],
    /* glide */ [1.0      , 1.0      , 1.0      , 1.0      , 1.0      , 0.03     , 0.03     , 1.0      , 0.04     , 1.0      , 1.0      , 1.0      , 1.0],
    /* echo  */ [0.0      , 0.0      , 0.0      , 0.04     , 0.0      , 0.0      , 0.0      , 0.45     , 0.40     , 0.40     , 0.25     , 0.1      , 0.0],
    /* room  */ [0.01     , 0.125    , 0.025    , 0.025    , 0.01     , 0.2      , 0.2      , 0.125    , 0.15     , 0.25     , 0.1      , 0.2      , 0.2],
    /* duck  */ [0.0      , 0.0      , 0.1      , 0.1      , 0.7      , 0.6      , 0.6      , 0.5      , 0.3      , 0.3      , 0.5      , 0.5      , 0.0],
];

/// How loud it all is.
const LOUDNESS: f32 = 0.46;

/// [`TABLE`] by instruments, a byte for each number.
static CODES: [[u8; NUMBERS]; TRACKS] = codes();

const fn codes() -> [[u8; NUMBERS]; TRACKS] {
    let mut codes = [[0; NUMBERS]; TRACKS];
    let mut track = 0;
    while track < TRACKS {
        let mut number = 0;
        while number < NUMBERS {
            // The first rows are how loud it is.
            let unit = if number <= NOISE { LOUDNESS } else { 1.0 };
            codes[track][number] = code(unit * TABLE[number][track]);
            number += 1;
        }
        track += 1;
    }
    codes
}

/// Codes in an octave: as many as leave room for 23 octaves, from [`LEAST`] to 18.
const PER_OCTAVE: f32 = 11.0;

/// The logarithm to base 2 of what code 0 would be, if it were not 0.
const LEAST: f32 = -19.0;

/// A number as a byte: 0, or its logarithm, rounded: to within 3.2 %.
const fn code(number: f32) -> u8 {
    if number == 0.0 {
        return 0;
    }
    /// 2^(1/22), half a step.
    const HALF: f32 = 1.032_008_5;
    let mut code = 0;
    let mut top = HALF / (1 << 19) as f32;
    while top < number {
        top *= HALF * HALF;
        code += 1;
    }
    assert!(code > 0, "a number the code has");
    code
}

/// All instruments' numbers.
#[inline(never)]
pub(super) fn read(instruments: &[Instrument; TRACKS]) {
    let codes = CODES.as_flattened();
    for (number, &code) in instruments.as_flattened().iter().zip(codes) {
        if code != 0 {
            number.set(Vec4::ONE * exp2(f32::from(code) / PER_OCTAVE + LEAST));
        }
    }
}
