use eightfold_tracer::{MAX_HEIGHT, MAX_WIDTH, Preset};
use eightfold_window::arguments::Arguments;
use eightfold_window::clock::SECOND;
use eightfold_window::cpu::{self, Isa};
use eightfold_window::line::Writer;

use super::SHOW_NANOSECONDS;
use super::flags::{Flag, Switch};

/// The size of windows and frames in pixels, by default.
pub const SIZE: (usize, usize) = (1024, 768);
/// Frames per second, by default.
pub const FPS: u64 = 60;

/// Limited by the memory for workers.
pub const MAX_THREADS: usize = 64;

const MAX_FPS: usize = 1000;

const MAX_PSNR: usize = 99;

/// About 30 years: sums of such times in nanoseconds stay far below 2^64.
const MAX_SECONDS: u64 = 1_000_000_000;

#[derive(Clone, Copy, Default)]
pub enum Task {
    #[default]
    Play,
    /// In nanoseconds, below [`SHOW_NANOSECONDS`].
    Still(u64),
    Help,
    Version,
}

#[derive(Default)]
pub struct Options {
    pub task: Task,
    /// In pixels, at most [`MAX_WIDTH`] and [`MAX_HEIGHT`]; `None` means at most [`SIZE`], by the
    /// monitor.
    pub size: Option<(usize, usize)>,
    pub is_fullscreen: bool,
    /// 1 to [`MAX_THREADS`]; `None` means one for each processor.
    pub threads: Option<usize>,
    /// `None` if this machine has none that the intro needs.
    pub isa: Option<Isa>,
    /// In nanoseconds, above 0; `None` means the show's length.
    pub length: Option<u64>,
    pub is_looping: bool,
    /// 1 to [`MAX_FPS`]; `None` means [`FPS`].
    pub fps: Option<u64>,
    /// In dB to exhaustive frames, 1 to [`MAX_PSNR`].
    pub psnr: Option<u64>,
    /// The fixed quality, if one is named.
    pub quality: Option<Preset>,
    has_two_qualities: bool,
    pub is_uncapped: bool,
    pub has_hud: bool,
    pub is_silent: bool,
}

#[derive(Clone, Copy)]
pub enum Misuse {
    UnknownFlag(&'static [u8]),
    NoValue(&'static Flag),
    BadValue(&'static Flag, &'static [u8]),
    Conflict(&'static str),
}

impl Misuse {
    pub fn write(&self, errors: &mut Writer) {
        match *self {
            Misuse::UnknownFlag(given) => {
                errors.text("flag is '").printable(given).text("'; must be one that --help lists")
            }
            Misuse::NoValue(flag) => flag.write_range(errors.text(flag.name).text(" has no value")),
            Misuse::BadValue(flag, given) => {
                let errors = errors.text(flag.name).text(" is '").printable(given).text("'");
                flag.write_range(errors)
            }
            Misuse::Conflict(flags) => errors.text(flags),
        };
        errors.text("\n").flush();
    }
}

impl Options {
    /// Parses the command line up to `--help` or `--version`. A flag's value is the next argument,
    /// or follows after `=`; the last of repeated flags counts.
    pub fn parse(mut arguments: Arguments) -> Result<Options, Misuse> {
        let mut options = Options { isa: cpu::shipped().next(), ..Options::default() };
        while let Some(argument) = arguments.next() {
            let (name, joined) = split_at_equals(argument);
            let flag = Flag::find(name).ok_or(Misuse::UnknownFlag(argument))?;
            let value = match joined {
                Some(value) if flag.value.is_empty() => return Err(Misuse::BadValue(flag, value)),
                Some(value) => value,
                None if flag.value.is_empty() => b"",
                None => arguments.next().ok_or(Misuse::NoValue(flag))?,
            };
            options.set(flag.switch, value).ok_or(Misuse::BadValue(flag, value))?;
            if matches!(flag.switch, Switch::Help | Switch::Version) {
                break;
            }
        }
        if options.has_two_qualities {
            return Err(Misuse::Conflict("--quality conflicts with another quality"));
        }
        if options.psnr.is_some() && (options.fps.is_some() || options.quality.is_some()) {
            return Err(Misuse::Conflict("--psnr conflicts with --fps and --quality"));
        }
        Ok(options)
    }

    fn set(&mut self, switch: Switch, value: &[u8]) -> Option<()> {
        match switch {
            Switch::Size => self.size = Some(size(value)?),
            Switch::Fullscreen => self.is_fullscreen = true,
            Switch::Threads => self.threads = Some(number(value, MAX_THREADS)?),
            Switch::Isa => self.isa = Some(cpu::named(value)?),
            Switch::Seconds => {
                self.length = Some(nanoseconds(value).filter(|&length| length > 0)?);
            }
            Switch::Loop => self.is_looping = true,
            Switch::Fps => self.fps = Some(number(value, MAX_FPS)? as u64),
            Switch::Psnr => self.psnr = Some(number(value, MAX_PSNR)? as u64),
            Switch::Quality => self.keep_to(Preset::named(value)?),
            Switch::Exhaustive => self.keep_to(Preset::Exhaustive),
            Switch::Uncapped => self.is_uncapped = true,
            Switch::Hud => self.has_hud = true,
            Switch::Silent => self.is_silent = true,
            Switch::Still => {
                let time = nanoseconds(value).filter(|&time| time < SHOW_NANOSECONDS)?;
                self.task = Task::Still(time);
            }
            Switch::Help => self.task = Task::Help,
            Switch::Version => self.task = Task::Version,
        }
        Some(())
    }

    fn keep_to(&mut self, quality: Preset) {
        self.has_two_qualities |= self.quality.is_some_and(|other| other != quality);
        self.quality = Some(quality);
    }
}

fn split_at_equals(argument: &[u8]) -> (&[u8], Option<&[u8]>) {
    let mut parts = argument.splitn(2, |&byte| byte == b'=');
    (parts.next().unwrap_or(argument), parts.next())
}

fn number(text: &[u8], max: usize) -> Option<usize> {
    decimal(text, 1, max as u64).filter(|&number| number > 0).map(|number| number as usize)
}

fn size(text: &[u8]) -> Option<(usize, usize)> {
    let mut sides = text.splitn(2, |&byte| byte == b'x');
    let [width, height] = [sides.next()?, sides.next()?];
    Some((number(width, MAX_WIDTH)?, number(height, MAX_HEIGHT)?))
}

/// Parses seconds up to [`MAX_SECONDS`], and rounds nanoseconds down.
fn nanoseconds(text: &[u8]) -> Option<u64> {
    decimal(text, SECOND, MAX_SECONDS * SECOND)
}

/// Parses a decimal number as a multiple of 1 / `one`, rounded down, at most `max`. If `one` is 1,
/// it has no fraction.
fn decimal(text: &[u8], one: u64, max: u64) -> Option<u64> {
    let (mut number, mut unit) = (0, one);
    let (mut has_digits, mut has_point) = (false, false);
    for &byte in text {
        let digit = u64::from(byte.wrapping_sub(b'0'));
        if byte == b'.' && !has_point && one > 1 {
            has_point = true;
        } else if digit > 9 {
            return None;
        } else {
            has_digits = true;
            if has_point {
                unit /= 10;
                number += digit * unit;
            } else {
                number = number * 10 + digit * one;
            }
            if number > max {
                return None;
            }
        }
    }
    has_digits.then_some(number)
}
