use eightfold_tracer::{MAX_HEIGHT, MAX_WIDTH, Quality};
use eightfold_window::cpu::{self, Isa};
use std::ffi::OsStr;
use std::fmt::{self, Display};
use std::ops::RangeInclusive;
use std::path::PathBuf;
use std::str::FromStr;
use std::thread::available_parallelism;

pub const QUALITY: &str = "exhaustive, thesis, or a preset, from finest to fastest";

/// The maximum exceeds the bands of the largest frame.
pub const THREADS: RangeInclusive<usize> = 1..=256;
/// Results of more frames would not fit in memory.
pub const FRAMES: RangeInclusive<usize> = 1..=100_000;
/// Seconds from the start of a scene.
pub const SECONDS: RangeInclusive<f32> = -1e6..=1e6;

pub const BAD_INPUT: u8 = 2;

#[derive(Debug)]
pub struct Exit {
    pub code: u8,
    pub message: String,
}

impl Exit {
    pub fn new(code: u8, message: impl Into<String>) -> Self {
        let message = message.into();
        Self { code, message }
    }

    pub fn bad_input(message: impl Into<String>) -> Self {
        Self::new(BAD_INPUT, message)
    }
}

impl Display for Exit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Exit {}

/// In pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    pub width: usize,
    pub height: usize,
}

impl Size {
    pub const fn new(width: usize, height: usize) -> Self {
        Self { width, height }
    }

    pub fn area(self) -> usize {
        self.width * self.height
    }

    /// Scales both sides, to at least 1.
    pub fn scaled(self, scale: f64) -> Self {
        let scaled = |side: usize| ((side as f64 * scale).round() as usize).max(1);
        Self::new(scaled(self.width), scaled(self.height))
    }
}

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let size = text.split_once('x').and_then(|(width, height)| {
            let (width, height) = (width.parse().ok()?, height.parse().ok()?);
            let fits = (1..=MAX_WIDTH).contains(&width) && (1..=MAX_HEIGHT).contains(&height);
            fits.then_some(Self { width, height })
        });
        size.ok_or_else(|| format!("must be WIDTHxHEIGHT, 1x1 to {MAX_WIDTH}x{MAX_HEIGHT}"))
    }
}

impl Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}x{}", self.width, self.height)
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NamedQuality {
    pub name: &'static str,
    pub quality: Quality,
}

impl NamedQuality {
    pub const EXHAUSTIVE: Self = Self { name: "exhaustive", quality: Quality::EXHAUSTIVE };
    pub const THESIS: Self = Self { name: "thesis", quality: Quality::THESIS };

    /// Returns exhaustive, thesis, then the presets from finest to fastest.
    pub fn all() -> impl Iterator<Item = Self> {
        let ladder = Quality::NAMES.into_iter().zip(Quality::LADDER);
        let ladder = ladder.map(|(name, &quality)| Self { name, quality });
        [Self::EXHAUSTIVE, Self::THESIS].into_iter().chain(ladder)
    }
}

impl FromStr for NamedQuality {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        Self::all().find(|quality| quality.name == name).ok_or_else(|| {
            let names: Vec<&str> = Self::all().map(|quality| quality.name).collect();
            format!("must be one of {}", names.join(", "))
        })
    }
}

impl Display for NamedQuality {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}

pub fn instruction_set(name: &str) -> Result<Isa, String> {
    let mut known = cpu::instruction_sets();
    known.find(|set| set.name == name).ok_or_else(|| {
        let names: Vec<&str> = cpu::instruction_sets().map(|set| set.name).collect();
        format!("must be one of {} on this machine", names.join(", "))
    })
}

pub fn processors() -> usize {
    available_parallelism().map_or(1, usize::from)
}

pub fn within<T>(range: RangeInclusive<T>) -> impl Fn(&str) -> Result<T, String> + Clone
where
    T: FromStr + PartialOrd + Display + Clone,
{
    move |text| {
        let number = text.parse().ok().filter(|number| range.contains(number));
        number.ok_or_else(|| format!("must be {} to {}", range.start(), range.end()))
    }
}

pub fn png_file(name: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(name);
    let is_png = |end: &OsStr| end.eq_ignore_ascii_case("png");
    let is_valid = !name.is_empty() && path.extension().is_none_or(is_png);
    let path = Some(path).filter(|_| is_valid);
    path.ok_or_else(|| "must be a .png file or -".to_owned())
}

pub fn distinct<T: PartialEq>(items: impl IntoIterator<Item = T>) -> Vec<T> {
    let mut distinct = Vec::new();
    for item in items {
        if !distinct.contains(&item) {
            distinct.push(item);
        }
    }
    distinct
}
