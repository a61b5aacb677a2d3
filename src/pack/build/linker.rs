//! This program as a linker: it has the program linked, and packs it.

use std::{
    env,
    ffi::{OsStr, OsString},
    fs,
    path::{Path, PathBuf},
    process::{Command, ExitStatus},
};

use super::{diet, order};
use crate::{Error, System, Version, executable::packed_size, pack_executable};

/// The largest file of a 64 kB intro.
const LIMIT: usize = 65_536;

/// The name of the stub's object file.
pub const STUB: &str = "stub.o";
const SETTINGS: &str = "settings";
/// The name of the diet's object file.
const DIET: &str = "diet.o";
/// The name of the file with functions in the order in which they are linked.
const ORDER: &str = "order";

/// The build script's settings for the linker, in a file beside it.
pub struct Settings {
    /// The linker's path or name.
    pub linker: String,
    /// The folder where the program is left as it was linked.
    pub unpacked: String,
    /// What it is for.
    pub system: System,
}

impl Settings {
    /// Writes them as lines; the last two are empty for Linux.
    pub fn write(&self, directory: &Path) -> Result<(), Error> {
        let [name, number] = match &self.system {
            System::Linux => ["", ""],
            System::Windows(Version { name, number }) => [name.as_str(), number],
        };
        let lines = [&*self.linker, &*self.unpacked, name, number];
        Ok(fs::write(directory.join(SETTINGS), lines.join("\n"))?)
    }

    fn read(directory: &Path) -> Result<Settings, Error> {
        let text = fs::read_to_string(directory.join(SETTINGS))?;
        let lines: Vec<_> = text.split('\n').map(String::from).collect();
        let [linker, unpacked, name, number] = <[String; 4]>::try_from(lines)
            .map_err(|_| "the settings are not those of the build script")?;
        Ok(Settings {
            linker,
            unpacked,
            system: if name.is_empty() {
                System::Linux
            } else {
                System::Windows(Version { name, number })
            },
        })
    }

    fn is_for_windows(&self) -> bool {
        matches!(self.system, System::Windows(_))
    }

    /// Whether the linker takes an order of functions.
    fn is_lld(&self) -> bool {
        let version = Command::new(&self.linker).arg("--version").output();
        version.is_ok_and(|version| String::from_utf8_lossy(&version.stdout).starts_with("LLD"))
    }

    /// Runs the linker with more arguments before those that it was to be given.
    fn run_linker(&self, more: &[OsString], arguments: &[OsString]) -> Result<ExitStatus, Error> {
        let is_wanted = |argument: &&OsString| !self.is_for_windows() || !is_of_linux(argument);
        Command::new(&self.linker)
            .args(more)
            .args(arguments.iter().filter(is_wanted))
            .status()
            .map_err(|error| format!("cannot run {}: {error}", self.linker).into())
    }
}

/// Links as it is told, and packs what came of it. Returns the exit code.
pub fn run(arguments: &[OsString]) -> i32 {
    link(arguments).unwrap_or_else(|error| {
        eprintln!("error: {error}");
        1
    })
}

fn link(arguments: &[OsString]) -> Result<i32, Error> {
    let own = env::current_exe()?;
    let directory = own.parent().ok_or("the linker is nowhere")?;
    let settings = Settings::read(directory)?;
    let words = words(arguments)?;
    let output = output(&words);
    let mut more = Vec::new();
    if output.is_some() {
        // Have the diet's definitions come first.
        let (object, missing) = diet::redirections(&words)?;
        if !missing.is_empty() {
            let missing = missing.join(", ");
            eprintln!("warning: the program may be larger than 64 kB: this std has no {missing}");
        }
        let path = directory.join(DIET);
        fs::write(&path, object)?;
        more.push(path.into_os_string());
    }
    // Have the linker link the program.
    let status = settings.run_linker(&more, arguments)?;
    let Some(path) = output.filter(|_| status.success()) else {
        // Without an output it was asked for its version.
        return Ok(status.code().unwrap_or(1));
    };
    // Have it do so again with functions in some orders, and at last in the one that packs best, if it can.
    if settings.is_lld() {
        let file = directory.join(ORDER);
        let mut option = OsString::from("--symbol-ordering-file=");
        option.push(&file);
        more.extend([option, "--no-warn-symbol-ordering".into()]);
        let link = |order: &[String]| -> Result<Vec<u8>, Error> {
            fs::write(&file, order.join("\n"))?;
            let status = settings.run_linker(&more, arguments)?;
            if !status.success() {
                return Err("the linker refuses an order of functions".into());
            }
            Ok(fs::read(&path)?)
        };
        let mut best = (usize::MAX, Vec::new());
        for order in order::by_likeness(&fs::read(&path)?)? {
            let size = packed_size(&link(&order)?).unwrap_or(usize::MAX - 1);
            if size < best.0 {
                best = (size, order);
            }
        }
        link(&best.1)?;
    }
    // Keep the program as it was linked, under the name that cargo gives it: with libraries of other features it has another.
    let mut name = path.file_name().ok_or("no name")?.to_owned();
    name.push(".unpacked");
    fs::copy(&path, Path::new(&settings.unpacked).join(name))?;
    let program = fs::read(&path)?;
    let stub = fs::read(directory.join(STUB))?;
    let file = match pack_executable(&program, &stub, &settings.system) {
        Err(error) if !settings.is_for_windows() => {
            eprintln!("warning: the program is not packed: {error}");
            return Ok(0);
        }
        packed => packed?,
    };
    if file.len() > LIMIT {
        let size = file.len();
        eprintln!("warning: the program has {size} bytes, more than the {LIMIT} of a 64 kB intro");
    }
    // In place, so that it stays executable.
    fs::write(&path, &file)?;
    if settings.is_for_windows() {
        fs::write(name_for_windows(&path)?, &file)?;
    }
    Ok(0)
}

/// Whether an argument is a library of Linux, or asks for what only its own programs have.
fn is_of_linux(argument: &OsStr) -> bool {
    let argument = argument.to_string_lossy();
    argument.starts_with("-l") || argument == "--eh-frame-hdr"
}

/// The name that a program for Windows has beside those that Cargo leaves.
fn name_for_windows(path: &Path) -> Result<PathBuf, Error> {
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    let name = name.rsplit_once('-').map_or(&*name, |(name, _)| name);
    let folder = path.parent().and_then(Path::parent).ok_or("no folder")?;
    Ok(folder.join(name).with_extension("exe"))
}

/// The arguments of the link. (Where there are many, they are in a file.)
fn words(arguments: &[OsString]) -> Result<Vec<OsString>, Error> {
    let mut words = Vec::new();
    for argument in arguments {
        match argument
            .to_str()
            .and_then(|argument| argument.strip_prefix('@'))
        {
            Some(file) => words.extend(
                fs::read_to_string(file)?
                    .split_whitespace()
                    .map(|word| OsString::from(word.trim_matches('"'))),
            ),
            None => words.push(argument.clone()),
        }
    }
    Ok(words)
}

/// Finds the output file of the link.
fn output(words: &[OsString]) -> Option<PathBuf> {
    let place = words.iter().position(|word| word == "-o")?;
    words.get(place + 1).map(PathBuf::from)
}
