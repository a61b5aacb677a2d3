//! Arguments that several commands share: sizes, qualities, threads, instruction sets, times.

use eightfold_tracer::{MAX_HEIGHT, MAX_WIDTH, Quality};
use eightfold_window::cpu::{self, Isa};
use std::fmt;
use std::path::PathBuf;
use std::str::FromStr;
use std::thread::available_parallelism;

/// The largest number of threads: more than a frame has bands for them.
const MAX_THREADS: usize = 256;
/// The largest number of frames, so that what is kept of each fits in memory.
const MAX_FRAMES: usize = 100_000;

/// An error in the command line that the parser cannot find, such as flags that contradict each other. It holds the message: the
/// flag and what it takes.
#[derive(Debug)]
pub struct BadInput(pub String);

impl fmt::Display for BadInput {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for BadInput {}

/// Width and height in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    pub width: usize,
    pub height: usize,
}

impl Size {
    pub const fn new(width: usize, height: usize) -> Self {
        Self { width, height }
    }

    /// The number of pixels.
    pub fn area(self) -> usize {
        self.width * self.height
    }
}

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let side = |text: &str, most| text.parse().ok().filter(|n| (1..=most).contains(n));
        text.split_once('x')
            .and_then(|(width, height)| {
                Some(Self {
                    width: side(width, MAX_WIDTH)?,
                    height: side(height, MAX_HEIGHT)?,
                })
            })
            .ok_or_else(|| format!("takes WIDTHxHEIGHT in pixels, 1x1 to {MAX_WIDTH}x{MAX_HEIGHT}"))
    }
}

impl fmt::Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}x{}", self.width, self.height)
    }
}

/// A named quality.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NamedQuality {
    pub name: &'static str,
    pub quality: Quality,
}

impl NamedQuality {
    pub const EXHAUSTIVE: Self = Self {
        name: "exhaustive",
        quality: Quality::EXHAUSTIVE,
    };
    pub const THESIS: Self = Self {
        name: "thesis",
        quality: Quality::THESIS,
    };

    /// All named qualities: the two that serve for comparison, then the ladder from the finest to the fastest preset.
    pub fn all() -> impl Iterator<Item = Self> {
        let ladder = Quality::NAMES.into_iter().zip(Quality::LADDER);
        let ladder = ladder.map(|(name, &quality)| Self { name, quality });
        [Self::EXHAUSTIVE, Self::THESIS].into_iter().chain(ladder)
    }
}

impl FromStr for NamedQuality {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        Self::all()
            .find(|quality| quality.name == name)
            .ok_or_else(|| {
                let names: Vec<&str> = Self::all().map(|quality| quality.name).collect();
                format!("takes one of {}", names.join(", "))
            })
    }
}

impl fmt::Display for NamedQuality {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}

/// Parses the name of an instruction set that this machine has.
pub fn instruction_set(name: &str) -> Result<Isa, String> {
    let mut known = cpu::instruction_sets();
    known.find(|set| set.name == name).ok_or_else(|| {
        let names: Vec<&str> = cpu::instruction_sets().map(|set| set.name).collect();
        format!("this machine has {}", names.join(", "))
    })
}

/// The number of processors.
pub fn processors() -> usize {
    available_parallelism().map_or(1, usize::from)
}

/// Parses a number of threads.
pub fn threads(text: &str) -> Result<usize, String> {
    number(text, MAX_THREADS)
}

/// Parses a number of frames.
pub fn frames(text: &str) -> Result<usize, String> {
    number(text, MAX_FRAMES)
}

/// Parses the number of a frame, counted from 0.
pub fn frame(text: &str) -> Result<usize, String> {
    let takes = format!("the number of a frame, 0 to {MAX_FRAMES}");
    parsed(text, |&number| number <= MAX_FRAMES, &takes)
}

/// Parses a number from 1 to `most`.
pub fn number(text: &str, most: usize) -> Result<usize, String> {
    let takes = format!("a number from 1 to {most}");
    parsed(text, |number| (1..=most).contains(number), &takes)
}

/// Parses a time in seconds.
pub fn seconds(text: &str) -> Result<f32, String> {
    parsed(text, |time: &f32| time.is_finite(), "seconds, such as 2.5")
}

/// Parses a value that is valid.
///
/// # Errors
/// A line with what the flag takes.
pub fn parsed<T: FromStr>(
    text: &str,
    is_valid: impl Fn(&T) -> bool,
    takes: &str,
) -> Result<T, String> {
    let value = text.parse().ok().filter(is_valid);
    value.ok_or_else(|| format!("takes {takes}"))
}

/// Parses the name of a PNG file. Another extension than `.png` is an error, since nothing else is written.
pub fn png_file(name: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(name);
    match path.extension() {
        Some(suffix) if !suffix.eq_ignore_ascii_case("png") => {
            Err("takes a file's name in .png, which is what is written, or -".to_owned())
        }
        _ if name.is_empty() => Err("takes a file's name".to_owned()),
        _ => Ok(path),
    }
}

/// Each item the first time that it comes.
pub fn distinct<T: PartialEq>(items: impl IntoIterator<Item = T>) -> Vec<T> {
    let mut distinct = Vec::new();
    for item in items {
        if !distinct.contains(&item) {
            distinct.push(item);
        }
    }
    distinct
}
