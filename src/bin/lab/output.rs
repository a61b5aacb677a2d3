//! Where results go: whole files, or nothing.

use anyhow::{Context, Result};
use std::fs::{self, File, Permissions};
use std::io::{self, Write};
use std::path::Path;
use tempfile::NamedTempFile;

/// Writes all of `bytes` to a file, or to standard output where the name is `-`.
///
/// A file appears under its name when it is whole and on the disk, and not before: what stood there stays until then,
/// and for good if something fails. What is no ordinary file (a device, a pipe) is written to as it is.
pub fn write(name: &Path, bytes: &[u8]) -> Result<()> {
    if name == Path::new("-") {
        let mut out = io::stdout().lock();
        return out
            .write_all(bytes)
            .and_then(|()| out.flush())
            .context("cannot write to standard output");
    }
    // A link stays a link: what it leads to is written.
    let path = fs::canonicalize(name).unwrap_or_else(|_| name.to_owned());
    let written = match fs::metadata(&path) {
        Ok(there) if !there.is_file() => in_place(&path, bytes),
        there => whole(&path, bytes, there.ok().map(|there| there.permissions())),
    };
    written.with_context(|| format!("cannot write {}", name.display()))
}

/// Whether a name could be written to, to be known before much work is done for it.
pub fn check(name: &Path) -> Result<()> {
    if name == Path::new("-") {
        return Ok(());
    }
    let path = fs::canonicalize(name).unwrap_or_else(|_| name.to_owned());
    let checked = match fs::metadata(&path) {
        Ok(there) if there.is_dir() => in_place(&path, &[]),
        // Who listens at a pipe's other end would hear it being opened.
        Ok(there) if !there.is_file() => Ok(()),
        _ => start(&path, None).map(drop),
    };
    checked.with_context(|| format!("cannot write {}", name.display()))
}

fn in_place(path: &Path, bytes: &[u8]) -> io::Result<()> {
    File::options().write(true).open(path)?.write_all(bytes)
}

fn whole(path: &Path, bytes: &[u8], permissions: Option<Permissions>) -> io::Result<()> {
    let mut file = start(path, permissions)?;
    file.write_all(bytes)?;
    file.as_file().sync_all()?;
    file.persist(path)?;
    Ok(())
}

/// An empty file next to where it will be; gone when it is dropped.
fn start(path: &Path, permissions: Option<Permissions>) -> io::Result<NamedTempFile> {
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
    builder.prefix(".lab-").suffix(".part");
    // Readable by others, as their umask has it, unless the file was there and said otherwise.
    #[cfg(unix)]
    builder.permissions(
        permissions.unwrap_or_else(|| std::os::unix::fs::PermissionsExt::from_mode(0o666)),
    );
    builder.tempfile_in(folder)
}
