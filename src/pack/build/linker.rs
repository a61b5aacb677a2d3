//! This program as a linker: it has the program linked, and packs it.

use std::{
    env,
    ffi::OsString,
    fs,
    path::{Path, PathBuf},
    process::Command,
};

use crate::{Error, pack_executable};

/// The largest file of a 64 kB intro.
const LIMIT: usize = 65_536;

/// The name of the stub's object file.
pub const STUB: &str = "stub.o";
const SETTINGS: &str = "settings";
const PACKED: &str = "packed";

/// The build script's settings for the linker, in a file beside it.
pub struct Settings {
    /// The linker's path or name.
    pub linker: String,
    /// The folder where the program is left as it was linked.
    pub unpacked: String,
    /// Whether it is packed.
    pub is_packed: bool,
}

impl Settings {
    pub fn write(&self, directory: &Path) -> Result<(), Error> {
        let what = if self.is_packed { PACKED } else { "" };
        let text = [&self.linker, &self.unpacked, what].join("\n");
        Ok(fs::write(directory.join(SETTINGS), text)?)
    }

    fn read(directory: &Path) -> Result<Settings, Error> {
        let text = fs::read_to_string(directory.join(SETTINGS))?;
        let [linker, unpacked, what] = text.split('\n').collect::<Vec<_>>()[..] else {
            return Err("the settings are not three lines".into());
        };
        Ok(Settings {
            linker: linker.into(),
            unpacked: unpacked.into(),
            is_packed: what == PACKED,
        })
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
    // Have the linker link the program.
    let own = env::current_exe()?;
    let directory = own.parent().ok_or("the linker is nowhere")?;
    let settings = Settings::read(directory)?;
    let status = Command::new(&settings.linker)
        .args(arguments)
        .status()
        .map_err(|error| format!("cannot run {}: {error}", settings.linker))?;
    if !status.success() {
        return Ok(status.code().unwrap_or(1));
    }
    let Some(path) = output(arguments)? else {
        // It was asked for its version.
        return Ok(0);
    };
    // Keep the program as it was linked, under the name that cargo gives it: with libraries of other features it has another.
    let program = fs::read(&path)?;
    let mut name = path.file_name().ok_or("no name")?.to_owned();
    name.push(".unpacked");
    fs::write(Path::new(&settings.unpacked).join(name), &program)?;
    if !settings.is_packed {
        return Ok(0);
    }
    // In place, so that it stays executable. It runs unpacked, too.
    let size = match pack_executable(&program, &fs::read(directory.join(STUB))?) {
        Ok(packed) => {
            fs::write(&path, &packed)?;
            packed.len()
        }
        Err(error) => {
            eprintln!("warning: the program is not packed: {error}");
            program.len()
        }
    };
    if size > LIMIT {
        eprintln!("warning: the program has {size} bytes, more than the {LIMIT} of a 64 kB intro");
    }
    Ok(0)
}

/// Finds the output file of the link. (Where there are many arguments, they are in a file.)
fn output(arguments: &[OsString]) -> Result<Option<PathBuf>, Error> {
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
    let place = words.iter().position(|word| word == "-o");
    Ok(place
        .and_then(|place| words.get(place + 1))
        .map(PathBuf::from))
}
