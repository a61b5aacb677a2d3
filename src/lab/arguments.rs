use eightfold_window::cpu::{self, Isa};
use std::ffi::OsStr;
use std::fmt::{self, Display};
use std::ops::RangeInclusive;
use std::path::PathBuf;
use std::str::FromStr;
use std::thread::available_parallelism;

pub const QUALITY: &str = "exhaustive, finest to fastest, or thesis";

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

pub fn png_file(name: &str) -> Result<PathBuf, &'static str> {
    let path = PathBuf::from(name);
    let is_png = |end: &OsStr| end.eq_ignore_ascii_case("png");
    let is_valid = !name.is_empty() && path.extension().is_none_or(is_png);
    is_valid.then_some(path).ok_or("must be a .png file or -")
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
