//! The song: what is played when.
//!
//! It is in A minor. The title's eight notes come back in every scene but one; the melody of the colonnade comes back in
//! the field, loud, and resolves in the finale. The last bar of each scene leads into the next one.
//!
//! All of it is text for people, made into a few hundred bytes when it is compiled. Spaces are for the eye.

use super::STEPS_PER_BAR;
use crate::grid;

/// Instruments, each with one voice.
pub(super) const TRACKS: usize = 13;

/// The track of the kick drum, which the others make room for.
pub(super) const KICK: usize = 0;

const BARS: usize = grid::BARS as usize;

/// Chords as MIDI notes: the bass, and three voices that move little from one to the next; 33 is A1, 55 Hz.
static CHORDS: [[u8; 4]; 8] = [
    [33, 36, 40, 43], // a: A minor 7
    [29, 36, 40, 45], // f: F major 7
    [36, 38, 40, 43], // c: C add 9
    [31, 35, 38, 45], // g: G add 9
    [38, 36, 41, 45], // d: D minor 7
    [28, 35, 38, 44], // E: E 7
    [28, 35, 38, 43], // e: E minor 7
    [33, 37, 40, 47], // A: A major add 9
];

/// The letters of [`CHORDS`].
const CHORD_NAMES: &[u8] = b"afcgdEeA";

/// The chord of each bar.
#[rustfmt::skip]
const HARMONY: [u8; BARS] = letters(
    b"aaffdE aaffcgdE afcgafdE fgeafgEE aaaafE fgeafg afgAAA", CHORD_NAMES);

/// How bright each bar gets, of 15: filters open with it.
#[rustfmt::skip]
const LIGHT: [u8; BARS] = letters(
    b"012246 44556788 66778898 54456789 abbcde ddeeff b86421", DIGITS);

/// The light and the chord of each bar, in four bits each.
static MOODS: [u8; BARS] = moods();

/// The notes of the melody, 1 to f: A minor from A4 up.
static SCALE: [u8; 16] = [
    0, 69, 71, 72, 74, 76, 77, 79, 81, 83, 84, 86, 88, 89, 91, 93,
];

/// What a track plays: the pattern of each bar, `a` its first one, and the patterns, sixteen steps each.
///
/// A step's digit, 1 to f, is how hard a drum is hit; for the rest, a note of the chord (1 to 4, an octave higher 5 to 8),
/// or of the scale.
struct Part {
    bars: &'static [u8],
    patterns: &'static [&'static [u8]],
}

#[rustfmt::skip]
const PARTS: [Part; TRACKS] = [
    // Kick.
    Part {
        bars: b"...... aaaaaaab aaaaaaab ........ cccccb aaaaab ......",
        patterns: &[
            b"f... f... f... f...",
            b"f... f... f... ....",
            b"f... f... f.c. f..c",
        ],
    },
    // Clap.
    Part {
        bars: b"...... ....aaab aaaaaaab .......c aaaaab aaaaab ......",
        patterns: &[
            b".... d... .... d...",
            b".... d..6 .... d9bf",
            b"4.4. 5.5. 6.7. 89bf",
        ],
    },
    // Hat.
    Part {
        bars: b"...... ..aaaaaa aaaaaaaa ........ aaaaaa aaaaaa ......",
        patterns: &[b"7494 7494 7494 7496"],
    },
    // Open hat.
    Part {
        bars: b"...... ....aaaa aaaaaaaa ........ aaaaaa aaaaaa ......",
        patterns: &[b"..c. ..c. ..c. ..c."],
    },
    // Bass.
    Part {
        bars: b"...... aaaaaaaa bbbbbbbb dddddd.. cccccc eeeeee ddd...",
        patterns: &[
            b"..1. ..1. ..1. ..1.",
            b"..11 ..15 ..11 .151",
            b"1.11 .151 1.11 5151",
            b"1... ..1. .... 1...",
            b".111 .111 .111 .115",
        ],
    },
    // Pad, and the same with its notes to other sides.
    Part {
        bars: b"aaaaaa aaaaaaaa aaaaaaaa aaaaaaaa ...... aaaaaa aaaa..",
        patterns: &[b"1... .... .... ...."],
    },
    Part {
        bars: b"aaaaaa aaaaaaaa aaaaaaaa aaaaaaaa ...... aaaaaa aaaa..",
        patterns: &[b"4... .... .... ...."],
    },
    // Arpeggio.
    Part {
        bars: b"..aaaa aaaabbbb bbbbbbbb cccccccc ..bbbb bbbbbb aaaa..",
        patterns: &[
            b"1.3. 2.4. 5.4. 3.2.",
            b"1351 3513 5135 7535",
            b"1.2. 3.4. 5.6. 7.6.",
        ],
    },
    // Melody.
    Part {
        bars: b"...... ........ ghijghij abcdef.. ...... abcdef e.....",
        patterns: &[
            b"5... ..4. 3... 1...",
            b"2... ..3. 4... 7...",
            b"7... ..5. 2... 4...",
            b"3... .... 5... 8...",
            b"8... ..7. 5... 3...",
            b"4... ..5. 7... 9...",
            b"3..4 ..5. .... ....",
            b"5..4 ..3. .... ....",
            b"3..4 ..5. ..7. ....",
            b"4... .... .... ....",
        ],
    },
    // Bell.
    Part {
        bars: b"aaaaaa ........ ........ aaaaaaaa ...... aaaaaa aaaa..",
        patterns: &[b"1... ..3. .... 5..."],
    },
    // Stabs.
    Part {
        bars: b"...... ........ ........ ........ aaaaaa aaaaaa ......",
        patterns: &[b"2..2 ..2. ..2. 2..."],
    },
    // Swells, two bars up to a cut and down from there.
    Part {
        bars: b"....a. ......a. ......a. ......a. ....a. ....a. ......",
        patterns: &[b"f... .... .... ...."],
    },
    // Boom.
    Part {
        bars: b"a.a.a. a....... a....... a....... a..... a..... a..a..",
        patterns: &[b"f... .... .... ...."],
    },
];

/// Digits of steps and of light.
const DIGITS: &[u8] = b"0123456789abcdef";

/// All patterns, silence first; the lowest four bits are the first step.
static PATTERNS: [u64; POOL.1] = {
    let mut patterns = [0; POOL.1];
    patterns.copy_from_slice(POOL.0.split_at(POOL.1).0);
    patterns
};

/// All parts' bars, after each other: a pattern's number in five bits, and how many times it comes beyond the first in three.
static RUNS: [u8; run_count()] = runs();

/// The digit of a track at a step of the song, 0 for none.
pub(super) fn step(track: usize, step: u32) -> u32 {
    let mut bars = track as u32 * grid::BARS + step / STEPS_PER_BAR;
    for run in &RUNS {
        let length = u32::from(run >> 5) + 1;
        if bars < length {
            let pattern = PATTERNS.get(usize::from(run & 31)).unwrap_or(&0);
            return (pattern >> (step % STEPS_PER_BAR * 4)) as u32 & 15;
        }
        bars -= length;
    }
    0
}

/// How bright a bar gets, 0 to 1, and its chord.
pub(super) fn mood(bar: u32) -> (f32, [u8; 4]) {
    let mood = MOODS.get(bar as usize).map_or(0, |&mood| mood);
    (f32::from(mood >> 4) / 15.0, CHORDS[usize::from(mood & 7)])
}

/// The MIDI note of a digit of the melody.
pub(super) fn scale(digit: u32) -> u32 {
    u32::from(SCALE[digit as usize & 15])
}

const fn moods() -> [u8; BARS] {
    let mut moods = [0; BARS];
    let mut bar = 0;
    while bar < BARS {
        moods[bar] = LIGHT[bar] << 4 | HARMONY[bar];
        bar += 1;
    }
    moods
}

/// Where a letter stands among others.
const fn place(letter: u8, among: &[u8]) -> u8 {
    let mut i = 0;
    while among[i] != letter {
        i += 1;
    }
    i as u8
}

/// The places of letters, one for each bar.
const fn letters(text: &[u8], among: &[u8]) -> [u8; BARS] {
    let mut places = [0; BARS];
    let (mut i, mut bar) = (0, 0);
    while i < text.len() {
        if text[i] != b' ' {
            places[bar] = place(text[i], among);
            bar += 1;
        }
        i += 1;
    }
    assert!(bar == BARS, "a letter for each bar");
    places
}

/// All different patterns with room for more, and how many they are. Silence is the first.
const POOL: ([u64; 32], usize) = {
    let mut all = [0; 32];
    let (mut count, mut track) = (1, 0);
    while track < TRACKS {
        let mut i = 0;
        while i < PARTS[track].patterns.len() {
            let pattern = pattern(PARTS[track].patterns[i]);
            if number(&all, count, pattern) == count {
                all[count] = pattern;
                count += 1;
            }
            i += 1;
        }
        track += 1;
    }
    (all, count)
};

/// The number of a pattern among others, or how many they are.
const fn number(all: &[u64], count: usize, pattern: u64) -> usize {
    let mut number = 0;
    while number < count && all[number] != pattern {
        number += 1;
    }
    number
}

/// A pattern's sixteen steps in four bits each.
const fn pattern(text: &[u8]) -> u64 {
    let mut steps = 0;
    let (mut i, mut count) = (0, 0);
    while i < text.len() {
        if text[i] != b' ' {
            let digit = if text[i] == b'.' {
                0
            } else {
                place(text[i], DIGITS)
            };
            steps |= (digit as u64) << (4 * count);
            count += 1;
        }
        i += 1;
    }
    assert!(count == STEPS_PER_BAR, "sixteen steps");
    steps
}

/// The number of the pattern that a track plays in each bar.
const fn bars(track: usize) -> [u8; BARS] {
    let mut bars = letters(PARTS[track].bars, b".abcdefghijklmnopqrstuvwxyz");
    let mut bar = 0;
    while bar < BARS {
        if bars[bar] > 0 {
            let pattern = pattern(PARTS[track].patterns[bars[bar] as usize - 1]);
            bars[bar] = number(&POOL.0, POOL.1, pattern) as u8;
        }
        bar += 1;
    }
    bars
}

const fn run_count() -> usize {
    let (mut count, mut bar) = (0, 0);
    while bar < TRACKS * BARS {
        bar += run(bar).1;
        count += 1;
    }
    count
}

const fn runs() -> [u8; run_count()] {
    let mut all = [0; run_count()];
    let (mut count, mut bar) = (0, 0);
    while bar < TRACKS * BARS {
        let (pattern, length) = run(bar);
        all[count] = pattern | ((length - 1) as u8) << 5;
        count += 1;
        bar += length;
    }
    all
}

/// The pattern at a bar, counted through all tracks, and how many times it comes from there, at most 8.
const fn run(start: usize) -> (u8, usize) {
    let bars = bars(start / BARS);
    let first = start % BARS;
    let mut length = 1;
    while length < 8 && first + length < BARS && bars[first + length] == bars[first] {
        length += 1;
    }
    (bars[first], length)
}
