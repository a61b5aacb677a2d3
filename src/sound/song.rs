//! The song: each instrument's notes.
//!
//! It is in A minor. The title's arpeggio returns in the model scene and the finale; the colonnade's melody returns in the swarm,
//! and resolves in the finale. Each scene's last bar leads into the next scene.
//!
//! The song is written as text, which the compiler parses. Spaces separate scenes and beats for the reader.

use super::STEPS_PER_BAR;

pub(super) const TRACKS: usize = 14;

/// The kick drum's track, which attenuates the others.
pub(super) const KICK: usize = 0;

/// The song's length, which the compiler checks against every track and the show.
pub(super) const BARS: usize = letters(HARMONY_TEXT);

/// Chords as MIDI notes: the bass, and three upper voices that move little from chord to chord. 33 is A1, 55 Hz.
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

const CHORD_NAMES: &[u8] = b"afcgdEeA";

const HARMONY_TEXT: &[u8] = b"aaffdE aaffdE afcgafdE fgeafgEE aaaafE afcgdE ddaafE fgeafg afgAAA";

static HARMONY: [u8; BARS] = indices_of(HARMONY_TEXT, CHORD_NAMES);

/// The brightness of each bar, 0 to 15, which opens the filters.
#[rustfmt::skip]
static LIGHT: [u8; BARS] = indices_of(
    b"012246 445678 66778898 54456789 889aab 99aabb 543468 eeffff b86421", DIGITS);

/// MIDI notes of the melody's digits 1 to f: A minor from A4 up.
static SCALE: [u8; 16] = [0, 69, 71, 72, 74, 76, 77, 79, 81, 83, 84, 86, 88, 89, 91, 93];

/// A track: for each bar a pattern with a digit for each step. Digits from 1 to 15 start the note that
/// [`Notes`](super::instruments::Notes) defines; 0 starts none.
struct Part {
    /// Each bar's pattern, counted from 1; 0 is silence.
    bars: [u8; BARS],
    patterns: &'static [[u8; STEPS]],
}

const STEPS: usize = STEPS_PER_BAR as usize;

#[rustfmt::skip]
static PARTS: [Part; TRACKS] = [
    // Kick.
    Part {
        bars: bars(b"...... aaaaab aaaaaaab ........ cccccb aaaaab dddd.. aaaaab ......"),
        patterns: &[
            pattern(b"f... f... f... f..."),
            pattern(b"f... f... f... ...."),
            pattern(b"f... f... f.c. f..c"),
            pattern(b"7... .... 7... ...."),
        ],
    },
    // Clap.
    Part {
        bars: bars(b"...... ..aaab aaaaaaab .......c aaaaab aaaaab .....c aaaaab ......"),
        patterns: &[
            pattern(b".... d... .... d..."),
            pattern(b".... d..6 .... d9bf"),
            pattern(b"4.4. 5.5. 6.7. 89bf"),
        ],
    },
    // Hat.
    Part {
        bars: bars(b"...... ..aaaa aaaaaaaa ........ aaaaaa aaaaaa ....aa bbbbbb ......"),
        patterns: &[pattern(b"7494 7494 7494 7496"), pattern(b"d9d9 d9d9 d9d9 d9df")],
    },
    // Open hat.
    Part {
        bars: bars(b"...... ....aa aaaaaaaa ........ ..aaaa ..aaaa ...... aaaaaa ......"),
        patterns: &[pattern(b"..c. ..c. ..c. ..c.")],
    },
    // Bass.
    Part {
        bars: bars(b"...... aaaaaa bbbbbbbb dddddd.. cccccc bbbbbb dddd.. eeeeee ddd..."),
        patterns: &[
            pattern(b"..1. ..1. ..1. ..1."),
            pattern(b"..11 ..15 ..11 .151"),
            pattern(b"1.11 .151 1.11 5151"),
            pattern(b"1... ..1. .... 1..."),
            pattern(b".111 .111 .111 .115"),
        ],
    },
    // Pads.
    Part {
        bars: bars(b"aaaaaa aaaaaa aaaaaaaa aaaaaaaa ...... aaaaaa aaaaaa aaaaaa aaaa.."),
        patterns: &[pattern(b"1... .... .... ....")],
    },
    Part {
        bars: bars(b"aaaaaa aaaaaa aaaaaaaa aaaaaaaa ...... aaaaaa aaaaaa aaaaaa aaaa.."),
        patterns: &[pattern(b"4... .... .... ....")],
    },
    // Arpeggio.
    Part {
        bars: bars(b"..aaaa aaaabb bbbbbbbb cccccccc ..bbbb bbbbbb ccccbb bbbbbb aaaa.."),
        patterns: &[
            pattern(b"1.3. 2.4. 5.4. 3.2."),
            pattern(b"1351 3513 5135 7535"),
            pattern(b"1.2. 3.4. 5.6. 7.6."),
        ],
    },
    // Melody.
    Part {
        bars: bars(b"...... ...... ghijghij abcdef.. ...... ghij.. ...... abcdef e....."),
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
        bars: bars(b"aaaaaa ...... ........ aaaaaaaa ...... ...... aaaaaa aaaaaa aaaa.."),
        patterns: &[pattern(b"1... ..3. .... 5...")],
    },
    // Stabs.
    Part {
        bars: bars(b"...... ...... ........ ........ ...aaa ...... ...... aaaaaa ......"),
        patterns: &[pattern(b"2..2 ..2. ..2. 2...")],
    },
    // Swells, which grow for two bars up to a cut.
    Part {
        bars: bars(b"....a. ....a. ......a. ......a. ....a. ....a. ....a. ....a. ......"),
        patterns: &[pattern(b"f... .... .... ....")],
    },
    // Boom.
    Part {
        bars: bars(b"a.a.a. a..... a....... a....... a..... aaaa.. a..... a..... a..a.."),
        patterns: &[pattern(b"f... .... .... ....")],
    },
    // Squares, halved where a scene begins, and doubled where it ends: an octave for each step.
    Part {
        bars: bars(b".....b a....b a......b a......b a....b a....b a....b a....b a....."),
        patterns: &[
            pattern(b"1.5. 9.d. .... ...."),
            pattern(b".... .... .... d951"),
        ],
    },
];

const DIGITS: &[u8] = b"0123456789abcdef";

/// Returns a track's digit; 0 after the song's end.
pub(super) fn step(track: usize, step: u32) -> u8 {
    let part = &PARTS[track];
    match part.bars.get((step / STEPS_PER_BAR) as usize) {
        None | Some(0) => 0,
        Some(number) => part.patterns[usize::from(*number) - 1][(step % STEPS_PER_BAR) as usize],
    }
}

/// Returns a bar's brightness, 0 to 1, and its chord's notes.
pub(super) fn mood(bar: u32) -> (f32, [u8; 4]) {
    let bar = bar as usize;
    let chord = CHORDS[usize::from(HARMONY[bar])];
    (f32::from(LIGHT[bar]) / 15.0, chord)
}

pub(super) fn scale(digit: u8) -> u8 {
    SCALE[usize::from(digit)]
}

const fn index_of(letter: u8, among: &[u8]) -> u8 {
    let mut i = 0;
    while among[i] != letter {
        i += 1;
    }
    i as u8
}

/// Parses a part's pattern numbers: `a` is the first pattern, `.` silence.
const fn bars(text: &[u8]) -> [u8; BARS] {
    indices_of(text, b".abcdefghijklmnopqrstuvwxyz")
}

/// Parses a pattern's sixteen digits; `.` is 0.
const fn pattern(text: &[u8]) -> [u8; STEPS] {
    indices_of(text, b".123456789abcdef")
}

const fn letters(text: &[u8]) -> usize {
    let (mut i, mut count) = (0, 0);
    while i < text.len() {
        count += (text[i] != b' ') as usize;
        i += 1;
    }
    count
}

const fn indices_of<const N: usize>(text: &[u8], among: &[u8]) -> [u8; N] {
    let mut indices = [0; N];
    let (mut i, mut count) = (0, 0);
    while i < text.len() {
        if text[i] != b' ' {
            indices[count] = index_of(text[i], among);
            count += 1;
        }
        i += 1;
    }
    assert!(count == N, "the text has to have N letters");
    indices
}
