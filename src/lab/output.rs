//! Writes files atomically.

use anyhow::{Context, Result, anyhow, ensure};
use serde::Serialize;
use std::fs::{self, File, Permissions};
use std::io::{self, Write};
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use tempfile::NamedTempFile;

/// Replaces a file; writes directly to standard output (`-`), devices and pipes.
pub fn write(name: &Path, bytes: &[u8]) -> Result<()> {
    let is_special = fs::metadata(name).is_ok_and(|there| !there.is_file());
    if name != Path::new("-") && !is_special {
        let mut part = part(name)?;
        let written = part.as_file_mut().write_all(bytes);
        written.with_context(|| cannot("write", name))?;
        return persist(part, name);
    }
    let written = if is_special {
        let opened = File::options().write(true).open(name);
        opened.and_then(|mut file| file.write_all(bytes))
    } else {
        let mut output = io::stdout().lock();
        output.write_all(bytes).and_then(|()| output.flush())
    };
    written.with_context(|| cannot("write", name))
}

pub fn write_json(name: &Path, value: &impl Serialize) -> Result<()> {
    let mut json = serde_json::to_vec_pretty(value)?;
    json.push(b'\n');
    write(name, &json)
}

/// Checks that a file can be written, before a long measurement.
pub fn check(name: &Path) -> Result<()> {
    ensure!(!name.is_dir(), "{}: is a folder", cannot("write", name));
    if name == Path::new("-") || name.exists() {
        return Ok(());
    }
    part(name).map(drop)
}

pub fn part(name: &Path) -> Result<NamedTempFile> {
    let folder = name.parent().filter(|folder| *folder != Path::new(""));
    let suffix = format!(".{}", name.extension().unwrap_or_default().display());
    let mut builder = tempfile::Builder::new();
    builder.prefix(".lab-").suffix(&suffix);
    builder.permissions(Permissions::from_mode(0o666));
    let part = builder.tempfile_in(folder.unwrap_or(Path::new(".")));
    part.map_err(|error| {
        // Omit the temporary name from the message.
        let why = error.to_string();
        let why = why.split(" at path ").next().unwrap_or_default();
        anyhow!("{}: {why}", cannot("write", name))
    })
}

pub fn persist(part: NamedTempFile, name: &Path) -> Result<()> {
    // Replace the target of a symbolic link.
    let path = fs::canonicalize(name).unwrap_or_else(|_| name.to_owned());
    let persisted = part.persist(path).map_err(|error| error.error);
    persisted.map(drop).with_context(|| cannot("write", name))
}

pub fn cannot(verb: &str, name: &Path) -> String {
    if name == Path::new("-") {
        format!("standard output: cannot {verb}")
    } else {
        format!("{}: cannot {verb}", name.display())
    }
}

pub fn read(path: &Path) -> Result<Vec<u8>> {
    fs::read(path).with_context(|| cannot("read", path))
}
