//! The intro's command line.

use core::num::NonZero;

use crate::parts::Parts;
use eightfold::{MAX_HEIGHT, MAX_WIDTH, Quality};
use eightfold_window::{arguments::Arguments, line};

/// The most threads that have a worker's memory waiting for them.
pub const MAX_THREADS: usize = 64;

/// What the viewer asks for: the values of the options by their numbers, 0 where one was not given.
pub struct Options([u64; VERSION + 1]);

/// What `--help` says: the name, which `--version` says too, then the options, a line each, and the keys. The command line
/// is read by these lines, and errors quote them.
static TEXT: [u8; joined_length(TEXTS)] = joined(TEXTS);

/// [`TEXT`] in parts.
const TEXTS: [&str; 4] = [
    concat!("eightfold ", env!("CARGO_PKG_VERSION"), "\n"),
    "\
--size WxH  of the window, 1x1 to 3840x2160 (1024x768)
--threads N  that trace, 1 to 64 (one for each processor)
--seconds S  until the end, above 0, such as 7.5 (96, the show)
--fps N  frames a second to hold, 1 to 1000 (60)
--quality Q  this one and no other: ",
    Quality::NAMES,
    "
--loop  start again instead of ending
--fullscreen  start over the whole screen
--uncapped  as many frames as can be, at default quality
--exhaustive  trace every pixel
--silent  play no sound
--help  say this
--version  say which this is
keys: F whole screen, W window, Esc end
",
];

// The lines of `TEXT` that are options; the first five take a value.

/// Width of the window in pixels, times 2^32, and its height.
pub const SIZE: usize = 1;
/// Threads that trace.
pub const THREADS: usize = 2;
/// Nanoseconds until it ends.
pub const SECONDS: usize = 3;
/// Frames a second.
const FPS: usize = 4;
/// One more than the number of the rung of the ladder of qualities. Beyond the ladder, every pixel is traced.
pub const QUALITY: usize = 5;
/// It starts again instead of ending.
pub const LOOP: usize = 6;
/// Starts over the whole screen.
pub const FULLSCREEN: usize = 7;
/// As many frames as can be.
pub const UNCAPPED: usize = 8;
const EXHAUSTIVE: usize = 9;
/// Without sound.
pub const SILENT: usize = 10;
const HELP: usize = 11;
const VERSION: usize = 12;

/// What `--quality default` says.
const DEFAULT: u64 = 4;

/// The most frames a second that can be asked for.
const MOST_FPS: u64 = 1000;

/// The longest time that can be asked for: what fits, at least a thousand million seconds.
const LONGEST: u64 = u64::MAX / 10;

impl Options {
    /// None of them.
    pub const NONE: Options = Options([0; _]);

    /// Reads the command line, and answers what only asks for an answer.
    ///
    /// Returns the exit code, if there is nothing to play: 0 when a question was answered, 1 when the answer
    /// could not be written, 2 when an argument is wrong, which standard error says.
    pub fn read(&mut self, mut arguments: Arguments) -> Option<i32> {
        while let Some(flag) = arguments.next() {
            let mut lines = Parts::of(&TEXT, b'\n').zip(&mut self.0).enumerate();
            let found = lines.find(|(_, (line, _))| {
                line.strip_prefix(flag).and_then(<[u8]>::first) == Some(&b' ')
            });
            let Some((option @ SIZE.., (line, place))) = found else {
                return Some(wrong(flag, b"--help says what there is"));
            };
            let value = if option <= QUALITY {
                arguments.next().unwrap_or_default()
            } else {
                b"1"
            };
            *place = match option {
                SIZE => size(value),
                THREADS => number(value, MAX_THREADS as u64, 0),
                FPS => number(value, MOST_FPS, 0),
                QUALITY => rung(value),
                HELP => return Some(answer(&TEXT)),
                VERSION => return Some(answer(const { TEXT.split_at(TEXTS[0].len()).0 })),
                _ => number(value, LONGEST, 9),
            };
            if *place == 0 {
                return Some(wrong(value, line));
            }
        }
        if self.0[UNCAPPED] != 0 && self.0[QUALITY] == 0 {
            self.0[QUALITY] = DEFAULT;
        }
        if self.0[EXHAUSTIVE] != 0 {
            self.0[QUALITY] = u64::MAX;
        }
        None
    }

    /// Frames a second to hold.
    pub fn fps(&self) -> NonZero<u64> {
        self.get(FPS).unwrap_or(const { NonZero::new(60).unwrap() })
    }

    /// The value of an option, if it was given.
    pub fn get(&self, option: usize) -> Option<NonZero<u64>> {
        NonZero::new(*self.0.get(option)?)
    }
}

/// The bytes of some texts, one after the other.
const fn joined<const N: usize>(texts: [&str; 4]) -> [u8; N] {
    let mut all = [0; N];
    let (mut text, mut end) = (0, 0);
    while text < texts.len() {
        let (_, rest) = all.split_at_mut(end);
        let (place, _) = rest.split_at_mut(texts[text].len());
        place.copy_from_slice(texts[text].as_bytes());
        end += texts[text].len();
        text += 1;
    }
    all
}

/// How many they are.
const fn joined_length(texts: [&str; 4]) -> usize {
    texts[0].len() + texts[1].len() + texts[2].len() + texts[3].len()
}

/// The names of the rungs of the ladder of qualities, where [`TEXT`] has them.
pub fn names() -> Parts {
    const START: usize = TEXTS[0].len() + TEXTS[1].len();
    const END: usize = START + TEXTS[2].len();
    Parts::of(const { TEXT.split_at(END).0.split_at(START).1 }, b' ')
}

/// One more than the number of the rung of the ladder of qualities with a name, or 0.
fn rung(name: &[u8]) -> u64 {
    names()
        .position(|known| known == name)
        .map_or(0, |rung| rung as u64 + 1)
}

/// Answers, and returns the exit code.
fn answer(text: &[u8]) -> i32 {
    i32::from(!line::printed(line::write(line::OUTPUT, text)))
}

/// Says in one line on standard error what is wrong, and returns the exit code.
fn wrong(given: &[u8], expected: &[u8]) -> i32 {
    line::complain("eightfold: can't use '\u{3}': \u{3}\n", &[given, expected]);
    2
}

/// Digits, with a point among them where there may be places after it: the number times ten for each place. 0 if it is
/// anything else, or more than `most`.
#[inline(never)]
fn number(text: &[u8], most: u64, places: u32) -> u64 {
    let mut number = 0;
    let mut left = places;
    let mut point = false;
    let mut text = text.iter();
    loop {
        let digit = match text.next() {
            None if left == 0 => return number,
            None => {
                point = true;
                0
            }
            Some(b'.') if !point && left > 0 => {
                point = true;
                continue;
            }
            Some(byte) => byte.wrapping_sub(b'0'),
        };
        if digit > 9 {
            return 0;
        }
        if point {
            // What is finer than that does not matter.
            if left == 0 {
                continue;
            }
            left -= 1;
        }
        number = number * 10 + u64::from(digit);
        if number > most {
            return 0;
        }
    }
}

/// Two whole numbers with an `x` between them, up to the largest picture, as [`SIZE`] says.
fn size(text: &'static [u8]) -> u64 {
    let mut sides = Parts::of(text, b'x');
    let mut side = |most: usize| number(sides.next().unwrap_or_default(), most as u64, 0);
    let (width, height) = (side(MAX_WIDTH), side(MAX_HEIGHT));
    if width == 0 || height == 0 || sides.next().is_some() {
        return 0;
    }
    width << 32 | height
}
