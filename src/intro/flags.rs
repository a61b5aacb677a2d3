//! The flags of the command line, and what `--help` says.

use core::fmt::{self, Display, Formatter, Write};

use eightfold_window::{cpu, line::Writer};

use super::qualities::NAMED;

/// What `--version` says.
pub const VERSION: &str = concat!("eightfold ", env!("CARGO_PKG_VERSION"));

/// The keys, as `--help` says them.
const KEYS: &str = "keys: F whole screen, W window, Esc end";

/// What a flag is about.
#[derive(Clone, Copy)]
pub enum Switch {
    Size,
    Fullscreen,
    Threads,
    Isa,
    Seconds,
    Loop,
    Fps,
    Quality,
    Exhaustive,
    Uncapped,
    Silent,
    Still,
    Help,
    Version,
}

/// A flag of the command line.
pub struct Flag {
    /// What it is about.
    pub switch: Switch,
    /// With its hyphens.
    pub name: &'static str,
    /// What its value looks like; empty if it takes none.
    pub value: &'static str,
    /// What it does, with the range of its value, and in brackets what holds without it.
    help: &'static str,
}

/// All flags. What each sets is told in [`Options`](super::options::Options).
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
        help: "start over the whole screen",
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
        help: "instruction set to trace with (the best that the CPU has):",
    },
    Flag {
        switch: Switch::Seconds,
        name: "--seconds",
        value: "S",
        help: "seconds until the end, above 0, such as 7.5 (96, the show)",
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
        help: "as many frames as can be, at default quality if none is named",
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
        help: "write the frame at so many seconds, 0 to 95.99, to standard output as PPM",
    },
    Flag {
        switch: Switch::Help,
        name: "--help",
        value: "",
        help: "say this",
    },
    Flag {
        switch: Switch::Version,
        name: "--version",
        value: "",
        help: "say which version this is",
    },
];

/// The width of the column that the flags and their values have in `--help`.
const COLUMN: usize = 16;

impl Flag {
    /// The flag with a name.
    pub fn find(name: &[u8]) -> Option<&'static Flag> {
        FLAGS.iter().find(|flag| flag.name.as_bytes() == name)
    }

    /// Writes what it does, and the names that it takes if there is a list of them.
    fn write_help(&self, f: &mut dyn Write) -> fmt::Result {
        f.write_str(self.help)?;
        match self.switch {
            Switch::Quality => write_names(f, NAMED.iter().map(|&(name, _)| name)),
            Switch::Isa => write_names(f, cpu::NAMES.iter().copied()),
            _ => Ok(()),
        }
    }
}

/// The flag, its value, and what `--help` says of it: for errors.
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

/// Writes what `--help` says.
pub fn write_help(output: &mut Writer) -> fmt::Result {
    writeln!(output, "{VERSION}")?;
    for flag in FLAGS {
        let width = COLUMN - flag.name.len();
        write!(output, "{} {:width$} ", flag.name, flag.value)?;
        flag.write_help(output)?;
        writeln!(output)?;
    }
    output.write_str("instruction sets of this CPU:")?;
    write_names(output, cpu::instruction_sets().map(|isa| isa.name))?;
    writeln!(output, "\n{KEYS}")
}

/// Writes names, each after a space.
fn write_names(f: &mut dyn Write, names: impl IntoIterator<Item = &'static str>) -> fmt::Result {
    names.into_iter().try_for_each(|name| write!(f, " {name}"))
}
