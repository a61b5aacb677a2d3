//! The intro's command line.

use crate::parts::Parts;
use eightfold::{MAX_HEIGHT, MAX_WIDTH, Quality};
use eightfold_window::{
    arguments::Arguments,
    clock::SECOND,
    line::{self, Line},
};

/// The most threads that have a worker's memory waiting for them.
pub const MAX_THREADS: usize = 64;

/// What the viewer asks for.
pub struct Options {
    /// Width and height of the window in pixels.
    pub size: (usize, usize),
    /// Threads that trace, or as many as there are processors.
    pub threads: Option<usize>,
    /// Nanoseconds until it ends, or as long as the show is.
    pub length: Option<u64>,
    /// Frames a second.
    pub fps: usize,
    /// The rung of the ladder of qualities, or whichever `fps` allows. Beyond the ladder, every pixel is traced.
    pub rung: Option<usize>,
    /// The options without a value that were given, a bit each.
    switches: u32,
}

/// The start of what `--help` says, which `--version` says too.
const NAME: &str = concat!("eightfold ", env!("CARGO_PKG_VERSION"), "\n");

/// The options, a line each. The command line is read by these, and errors quote them.
static OPTIONS: [u8; joined_length(LINES)] = joined(LINES);

/// [`OPTIONS`] in parts.
const LINES: [&str; 3] = [
    "\
--size WxH    size of the window, from 1x1 to 3840x2160 (1024x768)
--threads N   threads that trace, from 1 to 64 (one for each processor)
--seconds S   time until the end, above 0, such as 7.5 (25.13, one orbit)
--fps N       frames a second to hold, from 1 to 1000 (60)
--quality Q   one quality and no other: ",
    Quality::NAMES,
    "
--loop        start again instead of ending
--fullscreen  start over the whole screen
--uncapped    as many frames as can be, by default at default quality
--exhaustive  trace every pixel
--help        say this
--version     say which version this is
",
];

// The lines of `OPTIONS`; the first five take a value.
const SIZE: usize = 0;
const THREADS: usize = 1;
const SECONDS: usize = 2;
const FPS: usize = 3;
const QUALITY: usize = 4;
const LOOP: usize = 5;
/// Starts over the whole screen.
pub const FULLSCREEN: usize = 6;
/// As many frames as can be.
pub const UNCAPPED: usize = 7;
const EXHAUSTIVE: usize = 8;
const HELP: usize = 9;
const VERSION: usize = 10;

/// The most frames a second that can be asked for.
const MAX_FPS: usize = 1000;

/// The end of what `--help` says.
const KEYS: &str = "keys: F whole screen, W window, Esc end\n";

impl Options {
    /// Reads the command line, and answers what only asks for an answer.
    ///
    /// # Errors
    /// The exit code, if there is nothing to play: 0 when a question was answered, 1 when the answer
    /// could not be written, 2 when an argument is wrong, which standard error says.
    pub fn read(mut arguments: Arguments) -> Result<Options, i32> {
        let mut options = Options {
            size: (1024, 768),
            threads: None,
            length: None,
            fps: 60,
            rung: None,
            switches: 0,
        };
        while let Some(flag) = arguments.next() {
            let Some((option, line)) = find(flag) else {
                return Err(wrong(flag, b"--help says what there is"));
            };
            let value = if option <= QUALITY {
                arguments.next()
            } else {
                None
            };
            let value = value.unwrap_or_default();
            let right = match option {
                SIZE => size(value).map(|size| options.size = size),
                THREADS => whole(value, MAX_THREADS).map(|count| options.threads = Some(count)),
                SECONDS => seconds(value).map(|time| options.length = Some(time)),
                FPS => whole(value, MAX_FPS).map(|fps| options.fps = fps),
                QUALITY => rung(value).map(|rung| options.rung = Some(rung)),
                HELP => {
                    return Err(answer(&[NAME.as_bytes(), &OPTIONS, KEYS.as_bytes()]));
                }
                VERSION => return Err(answer(&[NAME.as_bytes()])),
                _ => {
                    options.switches |= 1 << option;
                    Some(())
                }
            };
            if right.is_none() {
                return Err(wrong(value, line));
            }
        }
        if options.has(LOOP) && options.length.is_none() {
            options.length = Some(u64::MAX);
        }
        if options.has(UNCAPPED) && options.rung.is_none() {
            options.rung = rung(b"default");
        }
        if options.has(EXHAUSTIVE) {
            options.rung = Some(usize::MAX);
        }
        Ok(options)
    }

    /// Whether an option without a value was given.
    pub fn has(&self, option: usize) -> bool {
        self.switches & 1 << option != 0
    }
}

/// The bytes of some texts, one after the other.
const fn joined<const N: usize>(texts: [&str; 3]) -> [u8; N] {
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
const fn joined_length(texts: [&str; 3]) -> usize {
    texts[0].len() + texts[1].len() + texts[2].len()
}

/// The line of an option: its number, and what it says.
fn find(flag: &[u8]) -> Option<(usize, &'static [u8])> {
    let mut lines = Parts::of(&OPTIONS, b'\n').enumerate();
    lines.find(|(_, line)| line.starts_with(flag) && line.get(flag.len()) == Some(&b' '))
}

/// The number of a rung of the ladder of qualities, by its name.
fn rung(name: &[u8]) -> Option<usize> {
    Parts::of(Quality::NAMES.as_bytes(), b' ').position(|known| known == name)
}

/// Answers, and returns the exit code.
fn answer(texts: &[&[u8]]) -> i32 {
    let said = texts.iter().all(|text| line::print(text));
    i32::from(!said)
}

/// Says in one line on standard error what is wrong, and returns the exit code.
fn wrong(given: &[u8], expected: &[u8]) -> i32 {
    let mut why = Line::new();
    why.text("eightfold: can't use '")
        .quote(given)
        .text("': ")
        .quote(expected)
        .text("\n");
    line::write(line::ERROR, why.bytes());
    2
}

/// A whole number from 1 to `most`.
#[inline(never)]
fn whole(text: &[u8], most: usize) -> Option<usize> {
    let mut number = 0;
    for digit in text {
        number = number * 10 + usize::from(digit.wrapping_sub(b'0'));
        if !digit.is_ascii_digit() || number > most {
            return None;
        }
    }
    (number > 0).then_some(number)
}

/// Two whole numbers with an `x` between them, up to the largest picture.
fn size(text: &'static [u8]) -> Option<(usize, usize)> {
    let mut sides = Parts::of(text, b'x');
    let width = whole(sides.next()?, MAX_WIDTH)?;
    let height = whole(sides.next()?, MAX_HEIGHT)?;
    sides.next().is_none().then_some((width, height))
}

/// Digits with at most one point among them, above 0 and up to a thousand million: nanoseconds.
fn seconds(text: &[u8]) -> Option<u64> {
    let mut time = 0;
    let mut unit = SECOND;
    let mut point = false;
    for &byte in text {
        match byte {
            b'0'..=b'9' if point => {
                unit /= 10;
                time += u64::from(byte - b'0') * unit;
            }
            b'0'..=b'9' if time <= SECOND * SECOND / 10 => {
                time = time * 10 + u64::from(byte - b'0') * SECOND;
            }
            b'.' if !point => point = true,
            _ => return None,
        }
    }
    (time > 0).then_some(time)
}
