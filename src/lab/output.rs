//! Where results go: whole files, or nothing.

use anyhow::{Context, Result};
use std::fs::{self, File, Permissions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use tempfile::NamedTempFile;

/// Writes all of `bytes` to a file, or to standard output where the name is `-`; see [`Sink`].
pub fn write(name: &Path, bytes: &[u8]) -> Result<()> {
    let mut sink = Sink::open(name)?;
    sink.write(bytes)?;
    sink.finish()
}

/// A result on its way to a file, or to standard output where the name is `-`.
///
/// A file appears under its name when it is whole and on the disk, and not before: what stood there stays until then,
/// and for good if something fails. What is no ordinary file (a device, a pipe) is written to as it is.
pub struct Sink {
    /// As the user gave it.
    name: PathBuf,
    place: Place,
}

enum Place {
    /// Standard output, written to as a file: std takes it for written where it is closed.
    Output(File),
    AsItIs(File),
    Whole(NamedTempFile, PathBuf),
}

impl Sink {
    /// Begins a result.
    pub fn open(name: &Path) -> Result<Self> {
        let place = if name == Path::new("-") {
            Place::Output(standard_output().with_context(|| cannot_write(name))?)
        } else {
            // A link stays a link: what it leads to is written.
            let path = fs::canonicalize(name).unwrap_or_else(|_| name.to_owned());
            let opened = match fs::metadata(&path) {
                Ok(there) if !there.is_file() => open_as_it_is(&path).map(Place::AsItIs),
                there => {
                    let permissions = there.ok().map(|there| there.permissions());
                    start(&path, permissions, PART).map(|file| Place::Whole(file, path))
                }
            };
            opened.with_context(|| cannot_write(name))?
        };
        let name = name.to_owned();
        Ok(Self { name, place })
    }

    /// Writes some more.
    pub fn write(&mut self, bytes: &[u8]) -> Result<()> {
        let written = match &mut self.place {
            Place::Output(file) | Place::AsItIs(file) => file.write_all(bytes),
            Place::Whole(file, _) => file.write_all(bytes),
        };
        written.with_context(|| cannot_write(&self.name))
    }

    /// Gives the result its name, now that it is whole.
    pub fn finish(self) -> Result<()> {
        match self.place {
            Place::Whole(file, path) => {
                persist(file, &path).with_context(|| cannot_write(&self.name))
            }
            Place::AsItIs(_) => {
                note(&self.name);
                Ok(())
            }
            Place::Output(_) => Ok(()),
        }
    }
}

#[cfg(unix)]
fn standard_output() -> io::Result<File> {
    use std::os::fd::AsFd;
    Ok(io::stdout().as_fd().try_clone_to_owned()?.into())
}

/// Set for a lab that writes what another one only reads: it does not say what it wrote.
pub const QUIET: &str = "EIGHTFOLD_LAB_QUIET";

/// The files that have been written: how many, and the first one's name.
static WRITTEN: Mutex<(usize, String)> = Mutex::new((0, String::new()));

/// Keeps in mind that a file has been written.
fn note(path: &Path) {
    let mut written = WRITTEN.lock().unwrap_or_else(PoisonError::into_inner);
    let (count, first) = &mut *written;
    if *count == 0 {
        *first = path.display().to_string();
    }
    *count += 1;
}

/// What this process has written to files, in words; `None` if nothing.
pub fn written() -> Option<String> {
    let written = WRITTEN.lock().unwrap_or_else(PoisonError::into_inner);
    match &*written {
        (0, _) => None,
        (1, first) => Some(first.clone()),
        (count, first) => Some(format!("{count} files, the first is {first}")),
    }
}

/// A file that another program fills under the name of `path()`, and that appears under its own name by
/// [`persist`]; until then its name ends in `suffix`.
pub fn start_for_another(name: &Path, suffix: &str) -> Result<NamedTempFile> {
    start(name, None, suffix).with_context(|| cannot_write(name))
}

/// Gives a whole file its name, once it is on the disk.
pub fn persist(file: NamedTempFile, path: &Path) -> io::Result<()> {
    file.as_file().sync_all()?;
    file.persist(path)?;
    note(path);
    Ok(())
}

/// What goes before the reason.
fn cannot_write(name: &Path) -> String {
    if name == Path::new("-") {
        "cannot write to standard output".to_owned()
    } else {
        format!("cannot write {}", name.display())
    }
}

/// Whether a name could be written to, to be known before much work is done for it.
pub fn check(name: &Path) -> Result<()> {
    if name == Path::new("-") {
        return Ok(());
    }
    let path = fs::canonicalize(name).unwrap_or_else(|_| name.to_owned());
    let checked = match fs::metadata(&path) {
        Ok(there) if there.is_dir() => open_as_it_is(&path).map(drop),
        // Who listens at a pipe's other end would hear it being opened.
        Ok(there) if !there.is_file() => Ok(()),
        _ => start(&path, None, PART).map(drop),
    };
    checked.with_context(|| cannot_write(name))
}

fn open_as_it_is(path: &Path) -> io::Result<File> {
    File::options().write(true).open(path)
}

/// How the name of a file that is not whole yet ends.
const PART: &str = ".part";

/// An empty file next to where it will be; gone when it is dropped.
fn start(path: &Path, permissions: Option<Permissions>, suffix: &str) -> io::Result<NamedTempFile> {
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
    let mut builder = tempfile::Builder::new();
    builder.prefix(".lab-").suffix(suffix);
    // Readable by others, as their umask has it, unless the file was there and said otherwise.
    #[cfg(unix)]
    builder.permissions(
        permissions.unwrap_or_else(|| std::os::unix::fs::PermissionsExt::from_mode(0o666)),
    );
    builder.tempfile_in(folder)
}
