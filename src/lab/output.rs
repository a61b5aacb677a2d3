//! Writes results: a file appears whole, or not at all.

use anyhow::{Context, Result};
use serde::Serialize;
use std::env;
use std::fs::{self, File, Permissions};
use std::io::{self, Write};
use std::mem;
use std::os::fd::AsFd;
use std::os::unix::fs::{OpenOptionsExt, PermissionsExt};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use tempfile::NamedTempFile;

/// Writes `bytes` to a file, or to standard output if the name is `-`.
///
/// The file gets its name once it is complete and on the disk. Until then, and if anything fails, a file of that name stays as it
/// was. Devices and pipes are written to directly.
pub fn write(name: &Path, bytes: &[u8]) -> Result<()> {
    if name == Path::new("-") {
        let written = standard_output().and_then(|mut output| output.write_all(bytes));
        return written.with_context(|| cannot_write(name));
    }
    write_file(name, bytes).with_context(|| cannot_write(name))?;
    note(name);
    Ok(())
}

/// Writes a value as lines of JSON.
pub fn write_json(name: &Path, value: &impl Serialize) -> Result<()> {
    let mut json = serde_json::to_vec_pretty(value)?;
    json.push(b'\n');
    write(name, &json)
}

fn write_file(name: &Path, bytes: &[u8]) -> io::Result<()> {
    // A symbolic link stays: the file that it points to is replaced.
    let path = fs::canonicalize(name).unwrap_or_else(|_| name.to_owned());
    match fs::metadata(&path) {
        Ok(there) if !there.is_file() => open_directly(&path)?.write_all(bytes),
        there => {
            let permissions = there.ok().map(|there| there.permissions());
            let mut part = start(&path, permissions, PART)?;
            part.write_all(bytes)?;
            part.persist(&path)
        }
    }
}

/// Standard output as a file: if it is closed, the standard library would report success.
fn standard_output() -> io::Result<File> {
    Ok(io::stdout().as_fd().try_clone_to_owned()?.into())
}

/// The environment variable that keeps the lab from printing what it wrote, for one that runs inside of another.
pub const QUIET: &str = "EIGHTFOLD_LAB_QUIET";

/// Whether this lab runs inside of another.
pub fn is_quiet() -> bool {
    env::var_os(QUIET).is_some()
}

/// The number of files written, and the name of the first.
static WRITTEN: Mutex<(usize, String)> = Mutex::new((0, String::new()));

/// Records that a file has been written, by the name that the user gave.
fn note(name: &Path) {
    let mut written = lock(&WRITTEN);
    let (count, first) = &mut *written;
    if *count == 0 {
        *first = name.display().to_string();
    }
    *count += 1;
}

fn lock<T>(shared: &Mutex<T>) -> MutexGuard<'_, T> {
    shared.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The files that this process has written, in words; `None` if there are none.
pub fn written() -> Option<String> {
    match &*lock(&WRITTEN) {
        (0, _) => None,
        (1, first) => Some(first.clone()),
        (count, first) => Some(format!("{count} files, the first is {first}")),
    }
}

/// A file that is not complete: a temporary one, which is deleted when dropped.
pub struct Part {
    file: NamedTempFile,
    _listed: Listed,
}

/// The paths of all parts, which nobody drops where a signal ends the program at once.
static PARTS: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// A path in that list, for as long as this lives.
struct Listed(PathBuf);

impl Drop for Listed {
    fn drop(&mut self) {
        lock(&PARTS).retain(|path| *path != self.0);
    }
}

impl Part {
    /// An empty one with a name of its own in a folder. `mode` has the permissions of a new file, as Unix has them.
    fn make(folder: &Path, mode: u32, suffix: &str) -> io::Result<Self> {
        let mut builder = tempfile::Builder::new();
        // Unlike `tempfile_in`, this leaves errors as they are: what is wrong is not the temporary name.
        let file = builder
            .prefix(".lab-")
            .suffix(suffix)
            .make_in(folder, |path| {
                let mut parts = lock(&PARTS);
                let file = File::options()
                    .read(true)
                    .write(true)
                    .create_new(true)
                    .mode(mode)
                    .open(path)?;
                parts.push(path.to_owned());
                Ok(file)
            })?;
        let _listed = Listed(file.path().to_owned());
        Ok(Self { file, _listed })
    }

    /// One for the system's folder of temporary files.
    pub fn passing(suffix: &str) -> io::Result<Self> {
        Self::make(&env::temp_dir(), 0o600, suffix)
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        self.file.path()
    }

    /// Writes to it. By itself a [`NamedTempFile`] puts its path behind every error.
    pub fn write_all(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.file.as_file_mut().write_all(bytes)
    }

    /// Gives a complete file its name, once it is on the disk.
    pub fn persist(self, path: &Path) -> io::Result<()> {
        self.file.as_file().sync_all()?;
        self.file.persist(path)?;
        Ok(())
    }
}

/// Deletes all parts of files for good: whoever begins another one waits until the program has ended.
pub fn discard() {
    let parts = lock(&PARTS);
    for path in &*parts {
        // It may have got its name just now.
        let _ = fs::remove_file(path);
    }
    mem::forget(parts);
}

/// A part that another program writes to. Its name ends in `suffix` until [`persist`] gives it its own.
pub fn start_for_another(name: &Path, suffix: &str) -> Result<Part> {
    start(name, None, suffix).with_context(|| cannot_write(name))
}

/// Gives such a part its name.
pub fn persist(part: Part, name: &Path) -> io::Result<()> {
    part.persist(name)?;
    note(name);
    Ok(())
}

/// The message in front of the reason.
fn cannot_write(name: &Path) -> String {
    if name == Path::new("-") {
        "cannot write to standard output".to_owned()
    } else {
        format!("cannot write {}", name.display())
    }
}

/// Checks that a file can be written, before much work is done for it.
pub fn check(name: &Path) -> Result<()> {
    if name == Path::new("-") {
        return Ok(());
    }
    let path = fs::canonicalize(name).unwrap_or_else(|_| name.to_owned());
    let checked = match fs::metadata(&path) {
        Ok(there) if there.is_dir() => open_directly(&path).map(drop),
        // Opening a pipe would wake up its reader.
        Ok(there) if !there.is_file() => Ok(()),
        _ => start(&path, None, PART).map(drop),
    };
    checked.with_context(|| cannot_write(name))
}

fn open_directly(path: &Path) -> io::Result<File> {
    File::options().write(true).open(path)
}

/// The suffix of incomplete files.
const PART: &str = ".part";

/// A part next to the path that it gets, with the permissions of the file that it replaces, or those of any new file.
fn start(path: &Path, permissions: Option<Permissions>, suffix: &str) -> io::Result<Part> {
    if path.file_name().is_none() {
        return Err(io::Error::new(
            io::ErrorKind::InvalidInput,
            "not a file name",
        ));
    }
    let folder = match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    };
    let mode = permissions.map_or(0o666, |permissions| permissions.mode());
    Part::make(folder, mode, suffix)
}
