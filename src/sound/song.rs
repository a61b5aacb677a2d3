//! The song: what is played when.
//!
//! It is in A minor. The title's eight notes come back in every scene but one; the melody of the colonnade comes back in
//! the swarm, loud, and resolves in the finale. The last bar of each scene leads into the next one.
//!
//! All of it is text, read when it is compiled. Spaces are for the eye.

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

/// The number of the chord of each bar.
#[rustfmt::skip]
static HARMONY: [u8; BARS] = places(
    b"aaffdE aaffcgdE afcgafdE fgeafgEE aaaafE fgeafg afgAAA", CHORD_NAMES);

/// How bright each bar gets, of 15: filters open with it.
#[rustfmt::skip]
static LIGHT: [u8; BARS] = places(
    b"012246 44556788 66778898 54456789 abbcde ddeeff b86421", DIGITS);

/// The notes of the melody, 1 to f: A minor from A4 up.
static SCALE: [u8; 16] = [
    0, 69, 71, 72, 74, 76, 77, 79, 81, 83, 84, 86, 88, 89, 91, 93,
];

/// What a track plays.
///
/// A step's digit, 1 to f, is how hard a drum is hit; for the rest, a note of the chord (1 to 4, an octave higher 5 to 8),
/// or of the scale. 0 is none.
struct Part {
    /// The number of the pattern of each bar, from 1; 0 is silence.
    bars: [u8; BARS],
    /// The digits of each pattern's steps.
    patterns: &'static [[u8; STEPS]],
}

/// Sixteenths of a bar.
const STEPS: usize = STEPS_PER_BAR as usize;

#[rustfmt::skip]
static PARTS: [Part; TRACKS] = [
    // Kick.
    Part {
        bars: bars(b"...... aaaaaaab aaaaaaab ........ cccccb aaaaab ......"),
        patterns: &[
            pattern(b"f... f... f... f..."),
            pattern(b"f... f... f... ...."),
            pattern(b"f... f... f.c. f..c"),
        ],
    },
    // Clap.
    Part {
        bars: bars(b"...... ....aaab aaaaaaab .......c aaaaab aaaaab ......"),
        patterns: &[
            pattern(b".... d... .... d..."),
            pattern(b".... d..6 .... d9bf"),
            pattern(b"4.4. 5.5. 6.7. 89bf"),
        ],
    },
    // Hat.
    Part {
        bars: bars(b"...... ..aaaaaa aaaaaaaa ........ aaaaaa aaaaaa ......"),
        patterns: &[pattern(b"7494 7494 7494 7496")],
    },
    // Open hat.
    Part {
        bars: bars(b"...... ....aaaa aaaaaaaa ........ aaaaaa aaaaaa ......"),
        patterns: &[pattern(b"..c. ..c. ..c. ..c.")],
    },
    // Bass.
    Part {
        bars: bars(b"...... aaaaaaaa bbbbbbbb dddddd.. cccccc eeeeee ddd..."),
        patterns: &[
            pattern(b"..1. ..1. ..1. ..1."),
            pattern(b"..11 ..15 ..11 .151"),
            pattern(b"1.11 .151 1.11 5151"),
            pattern(b"1... ..1. .... 1..."),
            pattern(b".111 .111 .111 .115"),
        ],
    },
    // Pad, and the same with its notes to other sides.
    Part {
        bars: bars(b"aaaaaa aaaaaaaa aaaaaaaa aaaaaaaa ...... aaaaaa aaaa.."),
        patterns: &[pattern(b"1... .... .... ....")],
    },
    Part {
        bars: bars(b"aaaaaa aaaaaaaa aaaaaaaa aaaaaaaa ...... aaaaaa aaaa.."),
        patterns: &[pattern(b"4... .... .... ....")],
    },
    // Arpeggio.
    Part {
        bars: bars(b"..aaaa aaaabbbb bbbbbbbb cccccccc ..bbbb bbbbbb aaaa.."),
        patterns: &[
            pattern(b"1.3. 2.4. 5.4. 3.2."),
            pattern(b"1351 3513 5135 7535"),
            pattern(b"1.2. 3.4. 5.6. 7.6."),
        ],
    },
    // Melody.
    Part {
        bars: bars(b"...... ........ ghijghij abcdef.. ...... abcdef e....."),
        patterns: &[
            pattern(b"5... ..4. 3... 1..."),
            pattern(b"2... ..3. 4... 7..."),
            pattern(b"7... ..5. 2... 4..."),
            pattern(b"3... .... 5... 8..."),
            pattern(b"8... ..7. 5... 3..."),
            pattern(b"4... ..5. 7... 9..."),
            pattern(b"3..4 ..5. .... ...."),
            pattern(b"5..4 ..3. .... ...."),
            pattern(b"3..4 ..5. ..7. ...."),
            pattern(b"4... .... .... ...."),
        ],
    },
    // Bell.
    Part {
        bars: bars(b"aaaaaa ........ ........ aaaaaaaa ...... aaaaaa aaaa.."),
        patterns: &[pattern(b"1... ..3. .... 5...")],
    },
    // Stabs.
    Part {
        bars: bars(b"...... ........ ........ ........ aaaaaa aaaaaa ......"),
        patterns: &[pattern(b"2..2 ..2. ..2. 2...")],
    },
    // Swells, two bars up to a cut and down from there.
    Part {
        bars: bars(b"....a. ......a. ......a. ......a. ....a. ....a. ......"),
        patterns: &[pattern(b"f... .... .... ....")],
    },
    // Boom.
    Part {
        bars: bars(b"a.a.a. a....... a....... a....... a..... a..... a..a.."),
        patterns: &[pattern(b"f... .... .... ....")],
    },
];

/// Digits of steps and of light.
const DIGITS: &[u8] = b"0123456789abcdef";

/// The digit of a track at a step of the song, 0 for none; there is none after its end.
pub(super) fn step(track: usize, step: u32) -> u8 {
    let part = &PARTS[track];
    match part.bars.get((step / STEPS_PER_BAR) as usize) {
        None | Some(0) => 0,
        Some(number) => part.patterns[usize::from(*number) - 1][(step % STEPS_PER_BAR) as usize],
    }
}

/// How bright a bar gets, 0 to 1, and its chord.
pub(super) fn mood(bar: u32) -> (f32, [u8; 4]) {
    let bar = bar as usize;
    let chord = CHORDS[usize::from(HARMONY[bar])];
    (f32::from(LIGHT[bar]) / 15.0, chord)
}

/// The MIDI note of a digit of the melody.
pub(super) fn scale(digit: u8) -> u8 {
    SCALE[usize::from(digit)]
}

/// Where a letter stands among others.
const fn place(letter: u8, among: &[u8]) -> u8 {
    let mut i = 0;
    while among[i] != letter {
        i += 1;
    }
    i as u8
}

/// The numbers of a part's patterns, one for each bar: `a` is its first one.
const fn bars(text: &[u8]) -> [u8; BARS] {
    places(text, b".abcdefghijklmnopqrstuvwxyz")
}

/// A pattern's sixteen digits.
const fn pattern(text: &[u8]) -> [u8; STEPS] {
    places(text, b".123456789abcdef")
}

/// The places of as many letters among others; spaces are left out.
const fn places<const N: usize>(text: &[u8], among: &[u8]) -> [u8; N] {
    let mut places = [0; N];
    let (mut i, mut count) = (0, 0);
    while i < text.len() {
        if text[i] != b' ' {
            places[count] = place(text[i], among);
            count += 1;
        }
        i += 1;
    }
    assert!(count == N, "a letter for each place");
    places
}
