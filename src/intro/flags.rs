use eightfold::show;
use eightfold_tracer::{MAX_HEIGHT, MAX_WIDTH, Preset};
use eightfold_window::{cpu, line::Writer, window::KEYS};

pub const VERSION: &str = concat!("eightfold ", env!("CARGO_PKG_VERSION"));

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

pub struct Flag {
    pub switch: Switch,
    pub name: &'static str,
    /// Its name in `--help`; empty without a value.
    pub value: &'static str,
    /// The effect, the range of the value, and the default in parentheses.
    help: &'static str,
}

#[rustfmt::skip]
const FLAGS: &[Flag] = &[
    flag(Switch::Size, "--size", "WxH", "size of the window or the frame, 1x1 to 3840x2160 (1024x768)"),
    flag(Switch::Fullscreen, "--fullscreen", "", "start in fullscreen"),
    flag(Switch::Threads, "--threads", "N", "threads that trace, 1 to 64 (one for each processor)"),
    flag(Switch::Isa, "--isa", "NAME", "instruction set (best by default):"),
    flag(Switch::Seconds, "--seconds", "S", "seconds to play, above 0, at most 1000000000 (116; endless with --loop)"),
    flag(Switch::Loop, "--loop", "", "repeat the show until Esc or --seconds"),
    flag(Switch::Fps, "--fps", "N", "target frame rate, 1 to 1000 (60)"),
    flag(Switch::Psnr, "--psnr", "DB", "target PSNR against exhaustive, 1 to 99 dB; conflicts with --fps and --quality"),
    flag(Switch::Quality, "--quality", "NAME", "quality (adaptive; --still: default):"),
    flag(Switch::Exhaustive, "--exhaustive", "", "trace every pixel, as --quality exhaustive does"),
    flag(Switch::Uncapped, "--uncapped", "", "draw without pauses; without --quality or --psnr, at quality default"),
    flag(Switch::Hud, "--hud", "", "show fps, traced points, and PSNR against exhaustive"),
    flag(Switch::Silent, "--silent", "", "play no sound"),
    flag(Switch::Still, "--still", "S", "time in seconds of a frame to print as PPM, from 0 to below 116"),
    flag(Switch::Help, "--help", "", "print this help"),
    flag(Switch::Version, "--version", "", "print the version"),
];

const fn flag(switch: Switch, name: &'static str, value: &'static str, help: &'static str) -> Flag {
    Flag { switch, name, value, help }
}

/// The width of flags and values in `--help`, in characters.
const COLUMN: usize = 16;

// Check the number of flags, the column's width, and the help's length and largest size.
const _: () = {
    assert!(show::LENGTH == 116.0 && MAX_WIDTH == 3840 && MAX_HEIGHT == 2160);
    assert!(FLAGS.len() == Switch::Version as usize + 1);
    let mut i = 0;
    while i < FLAGS.len() {
        let flag = &FLAGS[i];
        assert!(flag.name.len() + flag.value.len() <= COLUMN);
        i += 1;
    }
};

impl Flag {
    /// Finds a flag by its name; `-h` is `--help`.
    pub fn find(name: &[u8]) -> Option<&'static Flag> {
        let name = if name == b"-h" { b"--help" } else { name };
        FLAGS.iter().find(|flag| flag.name.as_bytes() == name)
    }

    fn write_help<'a>(&self, output: &'a mut Writer) -> &'a mut Writer {
        output.text(self.help);
        match self.switch {
            Switch::Quality => write_names(output, Preset::ALL.iter().map(|preset| preset.name())),
            Switch::Isa => write_names(output, cpu::shipped().map(|isa| isa.name)),
            _ => {}
        }
        output
    }

    pub fn write_range<'a>(&self, errors: &'a mut Writer) -> &'a mut Writer {
        errors.text("; must be ");
        if self.value.is_empty() {
            return errors.text("without a value");
        }
        self.write_help(errors.text(self.value).text(": "))
    }
}

pub fn write_help(output: &mut Writer) {
    output.text(VERSION).text("\n");
    for flag in FLAGS {
        output.text(flag.name).text(" ").text(flag.value);
        for _ in flag.name.len() + flag.value.len()..=COLUMN {
            output.text(" ");
        }
        flag.write_help(output).text("\n");
    }
    output.text("keys: ").text(KEYS).text("\n");
}

fn write_names(output: &mut Writer, names: impl IntoIterator<Item = &'static str>) {
    for name in names {
        output.text(" ").text(name);
    }
}
