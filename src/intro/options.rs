//! The options, parsed from the command line.

use core::fmt::{self, Display, Formatter};

use eightfold_tracer::{MAX_HEIGHT, MAX_WIDTH};
use eightfold_window::{
    arguments::Arguments,
    clock::SECOND,
    cpu::{self, Isa},
    line::{Printable, ascii},
};

use super::{
    SHOW_NANOSECONDS,
    flags::{Flag, Switch},
    qualities,
};

/// The maximum number of threads, which the memory for workers limits.
pub const MAX_THREADS: usize = 64;

const MAX_FPS: usize = 1000;

const MAX_PSNR: usize = 99;

/// The maximum number of seconds, about 30 years: sums of such times in nanoseconds stay far below 2^64.
const MAX_SECONDS: u64 = 1_000_000_000;

/// The task of the program.
#[derive(Clone, Copy)]
pub enum Task {
    /// Plays the show.
    Play,
    /// Writes the frame at a time in nanoseconds, below [`SHOW_NANOSECONDS`].
    Still(u64),
    /// Prints the help.
    Help,
    /// Prints the version.
    Version,
}

/// The task, and how to play or draw.
pub struct Options {
    pub task: Task,
    /// Width and height of the window or the frame in pixels, at most [`MAX_WIDTH`] and [`MAX_HEIGHT`].
    pub size: (usize, usize),
    pub is_fullscreen: bool,
    /// The number of threads that draw, 1 to [`MAX_THREADS`]; `None` means one for each processor.
    pub threads: Option<usize>,
    pub isa: Isa,
    /// The time until the end in nanoseconds, above 0; `None` means the length of the show.
    pub length: Option<u64>,
    pub is_looping: bool,
    /// The frame rate to hold, 1 to [`MAX_FPS`].
    pub fps: u64,
    /// Whether the user gave a frame rate.
    pub has_fps: bool,
    /// The accuracy to hold in dB to exhaustive frames, 1 to [`MAX_PSNR`]; a given frame rate takes precedence.
    pub psnr: Option<u64>,
    /// The fixed quality, as an index in [`qualities::NAMED`]; with `None` the governor chooses.
    pub quality: Option<usize>,
    pub is_uncapped: bool,
    /// Whether the numbers over the picture are shown from the start.
    pub has_hud: bool,
    pub is_silent: bool,
}

/// An error in the command line.
#[derive(Clone, Copy)]
pub enum Misuse {
    /// An unknown flag.
    UnknownFlag(&'static [u8]),
    /// A flag without its value, at the end of the command line.
    NoValue(&'static Flag),
    /// An invalid value.
    BadValue(&'static Flag, &'static [u8]),
    /// An instruction set that this CPU lacks.
    NotInThisCpu(&'static [u8]),
    /// Two different qualities.
    TwoQualities,
}

impl Display for Misuse {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match *self {
            Misuse::UnknownFlag(given) => {
                write!(f, "no such flag: '{}'; --help lists them", Printable(given))
            }
            Misuse::NoValue(flag) => write!(f, "no value: {flag}"),
            Misuse::BadValue(flag, given) => {
                write!(f, "can't use '{}': {flag}", Printable(given))
            }
            Misuse::NotInThisCpu(name) => write!(f, "this CPU has no {}", Printable(name)),
            Misuse::TwoQualities => f.write_str("more than one quality"),
        }
    }
}

impl Options {
    /// Returns the defaults.
    fn new() -> Options {
        Options {
            task: Task::Play,
            size: (1024, 768),
            is_fullscreen: false,
            threads: None,
            isa: cpu::best(),
            length: None,
            is_looping: false,
            fps: 60,
            has_fps: false,
            psnr: None,
            quality: None,
            is_uncapped: false,
            has_hud: false,
            is_silent: false,
        }
    }

    /// Parses the command line. A flag's value is the next argument, or follows after `=`. The last of repeated flags counts.
    /// Parsing stops after `--help` or `--version`.
    pub fn parse(mut arguments: Arguments) -> Result<Options, Misuse> {
        let mut options = Options::new();
        while let Some(argument) = arguments.next() {
            let (name, joined) = split_at_equals(argument);
            let flag = Flag::find(name).ok_or(Misuse::UnknownFlag(argument))?;
            let value = match joined {
                Some(value) if flag.value.is_empty() => return Err(Misuse::BadValue(flag, value)),
                Some(value) => value,
                None if flag.value.is_empty() => b"",
                None => arguments.next().ok_or(Misuse::NoValue(flag))?,
            };
            options.set(flag, value)?;
            if matches!(flag.switch, Switch::Help | Switch::Version) {
                break;
            }
        }
        Ok(options)
    }

    /// Sets a flag's option.
    fn set(&mut self, flag: &'static Flag, value: &'static [u8]) -> Result<(), Misuse> {
        let bad_value = Misuse::BadValue(flag, value);
        let text = ascii(value).ok_or(bad_value)?;
        match flag.switch {
            Switch::Size => self.size = size(text).ok_or(bad_value)?,
            Switch::Fullscreen => self.is_fullscreen = true,
            Switch::Threads => self.threads = Some(number(text, MAX_THREADS).ok_or(bad_value)?),
            Switch::Isa if !cpu::NAMES.contains(&text) => return Err(bad_value),
            Switch::Isa => self.isa = cpu::named(text).ok_or(Misuse::NotInThisCpu(value))?,
            Switch::Seconds => {
                let length = nanoseconds(text).filter(|&length| length > 0);
                self.length = Some(length.ok_or(bad_value)?);
            }
            Switch::Loop => self.is_looping = true,
            Switch::Fps => {
                self.fps = number(text, MAX_FPS).ok_or(bad_value)? as u64;
                self.has_fps = true;
            }
            Switch::Psnr => self.psnr = Some(number(text, MAX_PSNR).ok_or(bad_value)? as u64),
            Switch::Quality => self.keep_to(qualities::find(text).ok_or(bad_value)?)?,
            Switch::Exhaustive => self.keep_to(qualities::EXHAUSTIVE)?,
            Switch::Uncapped => self.is_uncapped = true,
            Switch::Hud => self.has_hud = true,
            Switch::Silent => self.is_silent = true,
            Switch::Still => {
                let time = nanoseconds(text).filter(|&time| time < SHOW_NANOSECONDS);
                self.task = Task::Still(time.ok_or(bad_value)?);
            }
            Switch::Help => self.task = Task::Help,
            Switch::Version => self.task = Task::Version,
        }
        Ok(())
    }

    /// Sets the fixed quality to an index in [`qualities::NAMED`].
    fn keep_to(&mut self, quality: usize) -> Result<(), Misuse> {
        match self.quality {
            Some(other) if other != quality => Err(Misuse::TwoQualities),
            _ => {
                self.quality = Some(quality);
                Ok(())
            }
        }
    }
}

/// Splits an argument at its first `=`.
fn split_at_equals(argument: &[u8]) -> (&[u8], Option<&[u8]>) {
    let mut parts = argument.splitn(2, |&byte| byte == b'=');
    (parts.next().unwrap_or(argument), parts.next())
}

/// Parses a decimal integer, 1 to `most`.
fn number(text: &str, most: usize) -> Option<usize> {
    // `parse` would accept a sign.
    is_digits(text)
        .then(|| text.parse().ok())?
        .filter(|number| (1..=most).contains(number))
}

/// Parses a width and a height, separated by `x`, up to the largest frame.
fn size(text: &str) -> Option<(usize, usize)> {
    let (width, height) = text.split_once('x')?;
    Some((number(width, MAX_WIDTH)?, number(height, MAX_HEIGHT)?))
}

/// Parses seconds, with or without a decimal fraction, up to [`MAX_SECONDS`]. Returns nanoseconds, rounded down.
fn nanoseconds(text: &str) -> Option<u64> {
    let (whole, fraction) = text.split_once('.').unwrap_or((text, ""));
    if whole.is_empty() && fraction.is_empty() || !is_digits(whole) || !is_digits(fraction) {
        return None;
    }
    let seconds = if whole.is_empty() {
        0
    } else {
        whole
            .parse()
            .ok()
            .filter(|&seconds| seconds <= MAX_SECONDS)?
    };
    let mut time = seconds * SECOND;
    let mut unit = SECOND;
    for digit in fraction.bytes() {
        unit /= 10;
        time += u64::from(digit - b'0') * unit;
    }
    Some(time)
}

/// Returns whether a text consists of decimal digits; an empty one does.
fn is_digits(text: &str) -> bool {
    text.bytes().all(|byte| byte.is_ascii_digit())
}
