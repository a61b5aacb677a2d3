//! What several commands take: a size, a quality, threads, an instruction set.

use eightfold::{MAX_HEIGHT, MAX_WIDTH, Quality};
use eightfold_window::cpu::{self, Isa};
use std::fmt;
use std::path::PathBuf;
use std::str::FromStr;

/// More threads than any frame has bands for.
const MAX_THREADS: usize = 256;
/// More frames than anybody waits for; what is kept of each has room.
const MAX_FRAMES: usize = 100_000;

/// Flags that make no sense together: a line that names them and says what they take.
#[derive(Debug)]
pub struct BadInput(String);

impl BadInput {
    /// As an error of a command.
    pub fn error(line: String) -> anyhow::Error {
        Self(line).into()
    }
}

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
    /// Pixels of a frame.
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
    /// The default one where squares are filled whatever may be seen between their corners: what the guard costs is measured
    /// by it, and it can be asked for nowhere else.
    pub const UNGUARDED: Self = Self {
        name: "unguarded",
        quality: Quality {
            guarded: false,
            ..Quality::DEFAULT
        },
    };

    /// The quality with so many samples a side of the pixels at edges, under its name.
    pub fn antialiased(mut self, samples: usize) -> Self {
        // One is what all have.
        self.quality.antialias = if samples > 1 { samples } else { 0 };
        self
    }

    /// All that have a name: the two to compare with, then the ladder from the finest to the fastest.
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

/// An instruction set that this machine has.
pub fn instruction_set(name: &str) -> Result<Isa, String> {
    let mut known = cpu::instruction_sets();
    known.find(|set| set.name == name).ok_or_else(|| {
        let names: Vec<&str> = cpu::instruction_sets().map(|set| set.name).collect();
        format!("this machine has {}", names.join(", "))
    })
}

/// A number of threads.
pub fn threads(text: &str) -> Result<usize, String> {
    number(text, MAX_THREADS)
}

/// A number of frames.
pub fn frames(text: &str) -> Result<usize, String> {
    number(text, MAX_FRAMES)
}

/// The number of a frame, from 0 on.
pub fn frame(text: &str) -> Result<usize, String> {
    let number = text.parse().ok();
    number
        .filter(|&n| n <= MAX_FRAMES)
        .ok_or_else(|| format!("takes the number of a frame, 0 to {MAX_FRAMES}"))
}

/// Samples a side for antialiasing.
pub fn antialias(text: &str) -> Result<usize, String> {
    number(text, Quality::MAX_ANTIALIAS)
}

/// A number from 1 to `most`.
pub fn number(text: &str, most: usize) -> Result<usize, String> {
    let number = text.parse().ok();
    number
        .filter(|n| (1..=most).contains(n))
        .ok_or_else(|| format!("takes a number from 1 to {most}"))
}

/// The name of a picture's file, which is a PNG whatever its name: a suffix that promises another format is refused.
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

/// Refuses a time of the last frame that is before that of the first.
pub fn check_span(from: f32, to: Option<f32>) -> anyhow::Result<()> {
    match to {
        Some(to) if to < from => Err(BadInput::error(format!(
            "--time-to: {to} s is before --time-from, {from} s"
        ))),
        _ => Ok(()),
    }
}

/// A time in seconds.
pub fn seconds(text: &str) -> Result<f32, String> {
    let number = text.parse().ok();
    number
        .filter(|t: &f32| t.is_finite())
        .ok_or_else(|| "takes seconds, such as 2.5".to_owned())
}
