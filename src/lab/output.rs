//! Writes results: a file appears whole, or not at all.

use anyhow::{Context, Result};
use std::fs::{self, File, Permissions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use tempfile::NamedTempFile;

/// Writes `bytes` to a file, or to standard output if the name is `-`; see [`Sink`].
pub fn write(name: &Path, bytes: &[u8]) -> Result<()> {
    let mut sink = Sink::open(name)?;
    sink.write(bytes)?;
    sink.finish()
}

/// A result that is being written to a file, or to standard output if the name is `-`.
///
/// The file gets its name once it is complete and on the disk. Until then, and if anything fails, a file of that name stays as it
/// was. Devices and pipes are written to directly.
pub struct Sink {
    /// The name as the user gave it.
    name: PathBuf,
    target: Target,
}

enum Target {
    /// Standard output, as a file: if it is closed, the standard library would report success.
    Output(File),
    /// A device or a pipe.
    Direct(File),
    /// A temporary file, and the path that it gets when it is complete.
    Whole(NamedTempFile, PathBuf),
}

impl Sink {
    /// Opens a result for writing.
    pub fn open(name: &Path) -> Result<Self> {
        let target = if name == Path::new("-") {
            Target::Output(standard_output().with_context(|| cannot_write(name))?)
        } else {
            // A symbolic link stays: the file that it points to is replaced.
            let path = fs::canonicalize(name).unwrap_or_else(|_| name.to_owned());
            let opened = match fs::metadata(&path) {
                Ok(there) if !there.is_file() => open_directly(&path).map(Target::Direct),
                there => {
                    let permissions = there.ok().map(|there| there.permissions());
                    start(&path, permissions, PART).map(|file| Target::Whole(file, path))
                }
            };
            opened.with_context(|| cannot_write(name))?
        };
        let name = name.to_owned();
        Ok(Self { name, target })
    }

    /// Writes some more.
    pub fn write(&mut self, bytes: &[u8]) -> Result<()> {
        let written = match &mut self.target {
            Target::Output(file) | Target::Direct(file) => file.write_all(bytes),
            Target::Whole(file, _) => file.write_all(bytes),
        };
        written.with_context(|| cannot_write(&self.name))
    }

    /// Completes the result: the file gets its name.
    pub fn finish(self) -> Result<()> {
        match self.target {
            Target::Whole(file, path) => {
                persist(file, &path).with_context(|| cannot_write(&self.name))
            }
            Target::Direct(_) => {
                note(&self.name);
                Ok(())
            }
            Target::Output(_) => Ok(()),
        }
    }
}

#[cfg(unix)]
fn standard_output() -> io::Result<File> {
    use std::os::fd::AsFd;
    Ok(io::stdout().as_fd().try_clone_to_owned()?.into())
}

/// The environment variable that keeps the lab from printing what it wrote, for one that runs inside of another.
pub const QUIET: &str = "EIGHTFOLD_LAB_QUIET";

/// The number of files written, and the name of the first.
static WRITTEN: Mutex<(usize, String)> = Mutex::new((0, String::new()));

/// Records that a file has been written.
fn note(path: &Path) {
    let mut written = WRITTEN.lock().unwrap_or_else(PoisonError::into_inner);
    let (count, first) = &mut *written;
    if *count == 0 {
        *first = path.display().to_string();
    }
    *count += 1;
}

/// The files that this process has written, in words; `None` if there are none.
pub fn written() -> Option<String> {
    let written = WRITTEN.lock().unwrap_or_else(PoisonError::into_inner);
    match &*written {
        (0, _) => None,
        (1, first) => Some(first.clone()),
        (count, first) => Some(format!("{count} files, the first is {first}")),
    }
}

/// A temporary file that another program writes to. Its name ends in `suffix` until [`persist`] gives it its own.
pub fn start_for_another(name: &Path, suffix: &str) -> Result<NamedTempFile> {
    start(name, None, suffix).with_context(|| cannot_write(name))
}

/// Gives a complete file its name, once it is on the disk.
pub fn persist(file: NamedTempFile, path: &Path) -> io::Result<()> {
    file.as_file().sync_all()?;
    file.persist(path)?;
    note(path);
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

/// An empty temporary file next to its final path. It is deleted when dropped.
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
    // The permissions of the file that is replaced, or those of any new file.
    #[cfg(unix)]
    builder.permissions(
        permissions.unwrap_or_else(|| std::os::unix::fs::PermissionsExt::from_mode(0o666)),
    );
    builder.tempfile_in(folder)
}
