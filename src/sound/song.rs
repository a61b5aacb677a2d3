//! The song: each instrument's notes, as text that the compiler parses. Spaces separate scenes and
//! beats for the reader; the harmony's also mark the cuts, before which all instruments rest.
//! `docs/sound.md` describes the music.

use super::STEPS_PER_BAR;

/// An instrument, which plays one note or chord at a time.
#[derive(Clone, Copy, Debug)]
pub enum Track {
    /// Moves the picture: bounces at 12 s, landings at 56 s, the sun at 80 s, turns at 92 s.
    Kick,
    /// On the beats between.
    Clap,
    /// In the method, the clicks.
    Hat,
    /// Between the beats.
    OpenHat,
    /// With the kick at 80 s.
    Tom,
    /// Plucked at 12 s, driven at 80 s.
    Bass,
    /// The first notes of the theme, then roots of chords.
    Sub,
    /// Chords in calm scenes.
    Vowel,
    /// Chords.
    Pad,
    /// The pad's chords.
    SecondPad,
    /// Sixteenths, in the climax.
    Arpeggio,
    /// The theme in minims: forwards and backwards, then in A major.
    Strings,
    /// The theme in the climax.
    Lead,
    /// The ball lands on a pipe with every note from 56 s.
    Chime,
    /// The theme in quavers, and the last note.
    Marimba,
    /// A note more in each bar of the method; sixteenths at the end.
    Square,
    /// Bubbles, then their pops, in canon with the marimba.
    Pop,
    /// Grows for two bars, up to a quaver before a cut.
    Riser,
    /// Where a scene begins.
    Boom,
}

pub(super) const TRACKS: usize = Track::Boom as usize + 1;

/// The song's length, which the compiler checks against the harmony, every track and the show.
pub(super) const BARS: usize = 58;

/// The theme in A minor as MIDI notes: each degree of the scale once, from E5. Digits 1 to 8 of a
/// melody count its notes.
pub const THEME: [u8; 8] = [76, 79, 81, 77, 72, 74, 71, 69];

/// Whether a note of the theme is a semitone higher in A major, where the song ends.
const RAISED: [u8; 8] = [0, 1, 0, 1, 1, 0, 0, 0];

/// The first bar in A major.
const MAJOR: u32 = 52;

/// Chords as MIDI notes: the bass, and three upper voices that move little from chord to chord. 33
/// is A1, 55 Hz.
static CHORDS: [[u8; 4]; 11] = [
    [33, 36, 40, 43], // a: A minor 7
    [29, 36, 40, 45], // f: F major 7
    [36, 38, 40, 43], // c: C add 9
    [31, 35, 38, 45], // g: G add 9
    [38, 36, 41, 45], // d: D minor 7
    [28, 35, 38, 44], // E: E 7
    [28, 35, 38, 43], // e: E minor 7
    [33, 37, 40, 47], // A: A major add 9
    [38, 37, 42, 45], // D: D major 7
    [35, 38, 42, 45], // b: B minor 7
    [28, 35, 38, 45], // s: E 7 with a suspended fourth
];

const CHORD_NAMES: &[u8] = b"afcgdEeADbs";

const HARMONY_TEXT: &[u8] = b"aaffdE ccffdg afcgafdE afcgadfe fadgfE cfdgfE egafcd fadgcE ADbsAA";

static LAST: [bool; BARS] = ends(HARMONY_TEXT);

static HARMONY: [u8; BARS] = indices_of(HARMONY_TEXT, CHORD_NAMES);

/// The brightness of each bar, 0 to 15, which opens the filters.
#[rustfmt::skip]
static LIGHT: [u8; BARS] = indices_of(
    b"445677 8899aa 45566789 45678987 89aabb 789abb bbccdd ddeeff 765432", DIGITS);

/// The loudness of each bar, 0 to 15, in dB.
#[rustfmt::skip]
static GAIN: [u8; BARS] = indices_of(
    b"a99999 cccccc bbbbcccc cccccccc cccccc bbbbbb cccccd ddddde cccccc", DIGITS);

/// A track: for each bar the number of its pattern, 0 for silence, and the patterns. A step's digit
/// from 1 to 15 starts the note that [`Notes`](super::instruments::Notes) defines.
struct Part([u8; BARS], &'static [[u8; STEPS]]);

const STEPS: usize = STEPS_PER_BAR as usize;

#[rustfmt::skip]
static PARTS: [Part; TRACKS] = [
    // Kick.
    Part(bars(b"...... ababdc ........ ........ defefc hihijk lllllk efefgc ......"), &patterns([
        b"b... .... b... ....", b"b... .... b... b...", b"f... f... f... ....",
        b"f... f... f... f...", b"f... f... f... f.c.", b"f... f... f.c. f...",
        b"f.c. f.c. f.c. f.c.", b"f... .... ..d. ....", b"f... ..d. ..d. ....",
        b"f... ..d. ..f. ....", b"f... ..f. .... ....", b"f... ..f. .... f...",
    ])),
    // Clap.
    Part(bars(b"...... .c.ccc ..ffffff ........ .aabac cdcdbe .....b aabadb ......"), &patterns([
        b".... d... .... d...", b".... d... .... d.9b", b".... .... d... ....",
        b".... ..7. d... .5..", b"4.4. 5.5. 6.7. ....", b".... 7... .... 7...",
    ])),
    // Hat.
    Part(bars(b"...... aababc ddeeffgg ........ .hhhhh abaccc iihhij hhjhjj ......"), &patterns([
        b"..7. ..7. ..7. ..7.", b"..7. ..74 ..7. .47.", b"4.7. 4.7. 4.74 ....",
        b"..9. e... ..9. e...", b".... e..a .... e..a", b"..a. e..a ..a. e...",
        b"..a. e.aa .aa. e.aa", b"7494 7494 7494 7496", b"6.34 ..63 4.6. 6.34",
        b"d9d9 d9d9 d9d9 d9df",
    ])),
    // Open hat.
    Part(bars(b"...... ....aa ........ ........ ..aaba ...... ...... bababa ......"), &patterns([
        b"..c. ..c. ..c. ....", b"..c. ..c. ..c. ..c.",
    ])),
    // Tom.
    Part(bars(b"...... ...... ........ ........ .....c ...... ababac ...... ......"), &patterns([
        b"f... ..d. .... b...", b"f..6 ..d. .6.. b.87", b"f..8 ..d. 8.8. ....",
    ])),
    // Bass.
    Part(bars(b"...... ababac eeeeffab ........ cdcdce fggfgg hihihi jjjjjj ......"), &patterns([
        b"1... ..1. ..5. 1...", b"1... 5.1. ..1. 5.2.", b"..1. ..1. ..1. ..1.",
        b"..11 ..15 ..11 ..51", b"1... .... .... ....", b"1.1. ..1. ..5. ..1.",
        b"1..1 ..1. 5..1 ..5.", b"1.11 1.11 1.11 1.11", b"1.11 1.11 1.15 1.51",
        b".111 .111 .111 .115",
    ])),
    // Sub.
    Part(bars(b".abcea ...... gdebgdea gdebgeda ...... ...... ...... ...... gefag."), &patterns([
        b"1... .... .... ....", b"2... .... .... ....", b"3... .... .... ....",
        b"4... .... .... ....", b"6... .... .... ....", b"7... .... .... ....",
        b"8... .... .... ....",
    ])),
    // Vowel.
    Part(bars(b"aaaaaa ...... ........ aaaaaaaa ...... ...... ...... ...... aaaaa."), &patterns([
        b"1... .... .... ....",
    ])),
    // Pads.
    Part(bars(b"...... ...... ........ ........ aaaaaa aaaaaa aaaaaa aaaaaa aaaaa."), &patterns([
        b"1... .... .... ....",
    ])),
    Part(bars(b"...... ...... ........ ........ aaaaaa aaaaaa aaaaaa aaaaaa aaaaa."), &patterns([
        b"4... .... .... ....",
    ])),
    // Arpeggio.
    Part(bars(b"...... .cddcd ........ ........ ...... ...... ...... aababa ......"), &patterns([
        b"1351 3513 5135 7535", b"1353 5753 1353 5795", b"..5. 3..1 ..5. 7...",
        b"..3. 5..7 .5.. 3...",
    ])),
    // Strings.
    Part(bars(b"...... ...... ........ abcdefgh ...... ...... jklmno ...... abcdi."), &patterns([
        b"1... .... 2... ....", b"3... .... 4... ....", b"5... .... 6... ....",
        b"7... .... 8... ....", b"8... .... 7... ....", b"6... .... 5... ....",
        b"4... .... 3... ....", b"2... .... 1... ....", b"8... .... .... ....",
        b"1... .... .... ....", b"2... .... .... ....", b"3... .... .... ....",
        b"4... .... .... ....", b"5... .... .... ....", b"6... .... .... ....",
    ])),
    // Lead.
    Part(bars(b"...... ...... ........ ........ ...... ...... ...... ababcd ......"), &patterns([
        b"1... ..2. 3... ..4.", b"5... ..6. 7... ..8.", b"1.2. 3.4. 5.6. 7.8.",
        b"1... 2... 3... ....",
    ])),
    // Chime.
    Part(bars(b"..c.c. ...... ........ ........ ababab ...... ...... ...... defg.."), &patterns([
        b"1... 2... 3... 4...", b"5... 6... 7... 8...", b".... .... .... 1...",
        b"1... .... 2... ....", b"3... .... 4... ....", b"5... .... 6... ....",
        b"7... .... 8... ....",
    ])),
    // Marimba.
    Part(bars(b"...... a.a.a. ........ ........ ...... ....a. ...... ...... .....b"), &patterns([
        b"1.2. 3.4. 5.6. 7.8.", b".... .... .... 8...",
    ])),
    // Square.
    Part(bars(b"...... ...... abcdefgh ........ ...... ...... ...... ...... .....i"), &patterns([
        b"1... .... .... ....", b"1.2. .... .... ....", b"1.2. 3... .... ....",
        b"1.2. 3.4. .... ....", b"1.2. 3.4. 5... ....", b"1.2. 3.4. 5.6. ....",
        b"1.2. 3.4. 5.6. 7...", b"1.2. 3.4. 5.67 8...", b".... 1234 5678 ....",
    ])),
    // Pop.
    Part(bars(b"...... ...... ........ ........ ...... abcdef ...... ...... ......"), &patterns([
        b"1... .... .... ....", b"1... .... 2... ....", b"1... 2... 3... 4...",
        b"1.2. 3.4. 5.6. 7.8.", b".... .... 1.2. 3.4.", b"5.6. 7.8. .... ....",
    ])),
    // Riser.
    Part(bars(b"....b. ....b. ......b. ......a. ....a. ....a. ....a. ....a. c.c..."), &patterns([
        b"f... .... .... ....", b"9... .... .... ....", b"e... .... .... ....",
    ])),
    // Boom.
    Part(bars(b"a.a.a. a..... a....... a....... a..... a..... a..... aaaa.. a..... "), &patterns([
        b"f... .... .... ....",
    ])),
];

const DIGITS: &[u8] = b"0123456789abcdef";

/// Returns a track's digit at a sixteenth of the song; 0 if no note starts.
pub(super) fn digit(track: usize, step: u32) -> u8 {
    let Part(bars, patterns) = &PARTS[track];
    match bars.get((step / STEPS_PER_BAR) as usize) {
        None | Some(0) => 0,
        Some(number) => patterns[usize::from(*number) - 1][(step % STEPS_PER_BAR) as usize],
    }
}

/// Returns a bar's brightness, 0 to 1, and its amplification in dB.
pub(super) fn mood(bar: u32) -> (f32, u8) {
    (f32::from(LIGHT[bar as usize]) / 15.0, GAIN[bar as usize])
}

pub(super) fn chord(bar: u32) -> [u8; 4] {
    CHORDS[usize::from(HARMONY[bar as usize])]
}

pub(super) fn is_last(bar: u32) -> bool {
    LAST[bar as usize]
}

pub(super) fn theme(digit: u8, bar: u32) -> u8 {
    let i = usize::from(digit) - 1;
    THEME[i] + if bar >= MAJOR { RAISED[i] } else { 0 }
}

const fn index_of(letter: u8, among: &[u8]) -> u8 {
    let mut i = 0;
    while among[i] != letter {
        i += 1;
    }
    i as u8
}

const fn bars(text: &[u8]) -> [u8; BARS] {
    indices_of(text, b".abcdefghijklmnopqrstuvwxyz")
}

/// Parses patterns of sixteen digits; `.` is 0.
const fn patterns<const N: usize>(texts: [&[u8]; N]) -> [[u8; STEPS]; N] {
    let (mut patterns, mut i) = ([[0; STEPS]; N], 0);
    while i < N {
        patterns[i] = indices_of(texts[i], b".123456789abcdef");
        i += 1;
    }
    patterns
}

/// Marks the last letter of each word.
const fn ends<const N: usize>(text: &[u8]) -> [bool; N] {
    let (mut ends, mut i, mut count) = ([false; N], 0, 0);
    while i < text.len() {
        if text[i] != b' ' {
            ends[count] = i + 1 == text.len() || text[i + 1] == b' ';
            count += 1;
        }
        i += 1;
    }
    ends
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
