//! The flags of the command line, and the text of `--help`.

use core::fmt::{self, Display, Formatter, Write};

use eightfold::show;
use eightfold_window::{cpu, line::Writer};

use super::qualities::NAMED;

/// The text of `--version`.
pub const VERSION: &str = concat!("eightfold ", env!("CARGO_PKG_VERSION"));

/// The keys, as `--help` lists them.
const KEYS: &str = "keys: F fullscreen, W window, H numbers, Esc end";

/// The options that flags set, in the order of [`FLAGS`].
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Switch {
    Size,
    Fullscreen,
    Threads,
    Isa,
    Seconds,
    Loop,
    Fps,
    Psnr,
    Quality,
    Exhaustive,
    Uncapped,
    Hud,
    Silent,
    Still,
    Help,
    Version,
}

/// A flag of the command line.
pub struct Flag {
    /// The option that it sets.
    pub switch: Switch,
    /// The flag itself, with its hyphens.
    pub name: &'static str,
    /// The name of its value in `--help`; empty if it takes none.
    pub value: &'static str,
    /// The effect in words, the range of its value, and the default in brackets.
    help: &'static str,
}

/// All flags. [`Options`](super::options::Options) documents what they set.
pub const FLAGS: &[Flag] = &[
    Flag {
        switch: Switch::Size,
        name: "--size",
        value: "WxH",
        help: "size of the window or the frame, 1x1 to 3840x2160 (1024x768)",
    },
    Flag {
        switch: Switch::Fullscreen,
        name: "--fullscreen",
        value: "",
        help: "start in fullscreen",
    },
    Flag {
        switch: Switch::Threads,
        name: "--threads",
        value: "N",
        help: "threads that trace, 1 to 64 (one for each processor)",
    },
    Flag {
        switch: Switch::Isa,
        name: "--isa",
        value: "NAME",
        help: "instruction set to trace with (the best of this CPU):",
    },
    Flag {
        switch: Switch::Seconds,
        name: "--seconds",
        value: "S",
        help: "seconds until the end, above 0, such as 7.5 (116, the show)",
    },
    Flag {
        switch: Switch::Loop,
        name: "--loop",
        value: "",
        help: "start again instead of ending",
    },
    Flag {
        switch: Switch::Fps,
        name: "--fps",
        value: "N",
        help: "frames a second to hold, 1 to 1000 (60)",
    },
    Flag {
        switch: Switch::Psnr,
        name: "--psnr",
        value: "DB",
        help: "accuracy to hold if no rate is named, in dB, 1 to 99",
    },
    Flag {
        switch: Switch::Quality,
        name: "--quality",
        value: "NAME",
        help: "keep to one quality (whichever holds the frame rate):",
    },
    Flag {
        switch: Switch::Exhaustive,
        name: "--exhaustive",
        value: "",
        help: "trace every pixel, as --quality exhaustive does",
    },
    Flag {
        switch: Switch::Uncapped,
        name: "--uncapped",
        value: "",
        help: "draw frames without a pause, at default quality unless one is named",
    },
    Flag {
        switch: Switch::Hud,
        name: "--hud",
        value: "",
        help: "show frames a second, points traced, and dB against exhaustive ones",
    },
    Flag {
        switch: Switch::Silent,
        name: "--silent",
        value: "",
        help: "play no sound",
    },
    Flag {
        switch: Switch::Still,
        name: "--still",
        value: "S",
        help: "write the frame at S seconds, from 0 to below 116, to standard output as PPM",
    },
    Flag {
        switch: Switch::Help,
        name: "--help",
        value: "",
        help: "print this help",
    },
    Flag {
        switch: Switch::Version,
        name: "--version",
        value: "",
        help: "print the version",
    },
];

/// The width, in characters, of the column with the flags and their values in `--help`.
const COLUMN: usize = 16;

// The table fits the enumeration, the column and the show's length, which two of the flags tell.
const _: () = {
    assert!(show::LENGTH == 116.0);
    assert!(FLAGS.len() == Switch::Version as usize + 1);
    let mut i = 0;
    while i < FLAGS.len() {
        let flag = &FLAGS[i];
        assert!(
            flag.switch as usize == i,
            "a flag for each switch, in order"
        );
        assert!(flag.name.len() + flag.value.len() <= COLUMN);
        assert!(!flag.help.is_empty());
        i += 1;
    }
};

impl Flag {
    /// The flag of a given name; `-h` stands for `--help`.
    pub fn find(name: &[u8]) -> Option<&'static Flag> {
        let name = if name == b"-h" { b"--help" } else { name };
        FLAGS.iter().find(|flag| flag.name.as_bytes() == name)
    }

    /// Writes what it does, and the values that it accepts if these are names.
    fn write_help(&self, f: &mut dyn Write) -> fmt::Result {
        f.write_str(self.help)?;
        match self.switch {
            Switch::Quality => write_names(f, NAMED.iter().map(|&(name, _)| name)),
            Switch::Isa => write_names(f, cpu::NAMES.iter().copied()),
            _ => Ok(()),
        }
    }
}

/// The flag's line of `--help`, for error messages.
impl Display for Flag {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)?;
        if !self.value.is_empty() {
            write!(f, " {}", self.value)?;
        }
        f.write_str("  ")?;
        self.write_help(f)
    }
}

/// Writes the text of `--help`.
pub fn write_help(output: &mut Writer) -> fmt::Result {
    writeln!(output, "{VERSION}")?;
    for flag in FLAGS {
        let width = COLUMN - flag.name.len();
        write!(output, "{} {:width$} ", flag.name, flag.value)?;
        flag.write_help(output)?;
        writeln!(output)?;
    }
    output.write_str("instruction sets of this CPU:")?;
    write_names(output, cpu::shipped().map(|isa| isa.name))?;
    writeln!(output, "\n{KEYS}")
}

/// Writes names, each preceded by a space.
fn write_names(f: &mut dyn Write, names: impl IntoIterator<Item = &'static str>) -> fmt::Result {
    names.into_iter().try_for_each(|name| write!(f, " {name}"))
}
