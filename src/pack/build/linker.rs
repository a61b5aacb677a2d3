//! Acts as the linker: runs the real one, and packs its output.

use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus};
use std::{env, fs};

use super::{at, order, redirect, variable};
use crate::{Error, System, executable::packed_size, pack_executable};

const LIMIT: usize = 65_536;

pub const STUB: &str = "stub.o";
const ORDER: &str = "order";

/// The library for unwinding. Without it GNU ld drops 775 bytes.
const UNWINDER: &str = "-lgcc_s";

/// Environment variables: the real linker's path or name, and the target system.
pub const LINKER_VARIABLE: &str = "EIGHTFOLD_LINKER";
pub const SYSTEM_VARIABLE: &str = "EIGHTFOLD_SYSTEM";

struct Settings {
    linker: String,
    system: System,
}

impl Settings {
    fn from_environment() -> Result<Settings, Error> {
        let system = match &*variable(SYSTEM_VARIABLE)? {
            "windows" => System::Windows,
            _ => System::Linux,
        };
        Ok(Settings { linker: variable(LINKER_VARIABLE)?, system })
    }

    fn is_for_windows(&self) -> bool {
        self.system == System::Windows
    }

    fn is_lld(&self) -> bool {
        let version = Command::new(&self.linker).arg("--version").output();
        version.is_ok_and(|version| String::from_utf8_lossy(&version.stdout).starts_with("LLD"))
    }

    fn run_linker(&self, more: &[OsString], arguments: &[OsString]) -> Result<ExitStatus, Error> {
        let is_wanted = |argument: &&OsString| {
            *argument != UNWINDER && (!self.is_for_windows() || !is_of_linux(argument))
        };
        let mut linker = Command::new(&self.linker);
        let linker = linker.args(more).args(arguments.iter().filter(is_wanted));
        at(&self.linker, linker.status())
    }
}

pub fn run(arguments: &[OsString]) -> i32 {
    link(arguments).unwrap_or_else(|error| {
        eprintln!("error: {error}");
        1
    })
}

fn link(arguments: &[OsString]) -> Result<i32, Error> {
    let settings = Settings::from_environment()?;
    let (mut more, mut missing) = (Vec::new(), Vec::new());
    let output = output(arguments);
    if output.is_some() {
        (more, missing) = redirect::redirections(arguments)?;
    }
    if !missing.is_empty() {
        let missing = missing.join(", ");
        eprintln!("warning: this std lacks {missing}; the program may exceed 64 kB");
        more.push(UNWINDER.into());
    }
    let status = settings.run_linker(&more, arguments)?;
    let Some(path) = output.filter(|_| status.success()) else {
        // Without an output, the call asked for the linker's version.
        return Ok(status.code().unwrap_or(1));
    };
    let own = env::current_exe()?;
    let directory = own.parent().ok_or("linker has no folder")?;
    if settings.is_lld() {
        link_in_order(&settings, arguments, more, &directory.join(ORDER), &path)?;
    }
    pack(&settings, directory, &path)?;
    Ok(0)
}

/// Tries several orders of functions, and links in the one that packs best.
fn link_in_order(
    settings: &Settings,
    arguments: &[OsString],
    mut more: Vec<OsString>,
    file: &Path,
    output: &Path,
) -> Result<(), Error> {
    let option = format!("--symbol-ordering-file={}", file.display());
    more.extend([option.into(), "--no-warn-symbol-ordering".into()]);
    let read = || at(output, fs::read(output));
    let link = |order: &[String]| {
        at(file, fs::write(file, order.join("\n")))?;
        let status = settings.run_linker(&more, arguments)?;
        if !status.success() {
            return Err(format!("{} failed: {status}", settings.linker).into());
        }
        read()
    };
    let mut best = (usize::MAX, Vec::new());
    for order in order::by_likeness(&read()?)? {
        let size = packed_size(&link(&order)?).unwrap_or(usize::MAX - 1);
        if size < best.0 {
            best = (size, order);
        }
    }
    link(&best.1).map(drop)
}

fn pack(settings: &Settings, directory: &Path, path: &Path) -> Result<(), Error> {
    // Keep the unpacked program under cargo's name, whose hash depends on the features.
    let mut name = path.file_name().ok_or("output has no name")?.to_owned();
    name.push(".unpacked");
    let unpacked = path.with_file_name(name);
    at(&unpacked, fs::copy(path, &unpacked))?;
    let program = at(path, fs::read(path))?;
    let stub = directory.join(STUB);
    let stub = at(&stub, fs::read(&stub))?;
    let file = match pack_executable(&program, &stub, &settings.system) {
        Err(error) if !settings.is_for_windows() => {
            eprintln!("warning: the program is not packed: {error}");
            return Ok(());
        }
        packed => packed?,
    };
    if file.len() > LIMIT {
        let size = file.len();
        eprintln!("warning: program size is {size}; must be at most {LIMIT}");
    }
    at(path, fs::write(path, &file))?;
    if settings.is_for_windows() {
        let path = name_for_windows(path)?;
        at(&path, fs::write(&path, &file))?;
    }
    Ok(())
}

fn is_of_linux(argument: &OsStr) -> bool {
    let argument = argument.to_string_lossy();
    argument.starts_with("-l") || argument == "--eh-frame-hdr"
}

fn name_for_windows(path: &Path) -> Result<PathBuf, Error> {
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    let name = name.rsplit_once('-').map_or(&*name, |(name, _)| name);
    let folder = path.parent().and_then(Path::parent).ok_or("output has no folder")?;
    Ok(folder.join(name).with_extension("exe"))
}

fn output(words: &[OsString]) -> Option<PathBuf> {
    let place = words.iter().position(|word| word == "-o")?;
    words.get(place + 1).map(PathBuf::from)
}
