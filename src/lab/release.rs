//! `lab release`: packs the intro and its text file into a zip.

use crate::{cargo, output};
use anyhow::{Context, Result, bail};
use clap::Args;
use std::fs;
use std::io::{Cursor, Write};
use std::path::{Path, PathBuf};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

/// Builds the intro, checks that it is at most 65,536 bytes, and packs it and its nfo into a zip
///
/// Prints the sizes. The same program gives the same zip, byte for byte.
#[derive(Args)]
pub struct Arguments {
    /// Program to pack, built before [default: the intro, which is built]
    #[arg(long, value_name = "FILE")]
    intro: Option<PathBuf>,
    /// File to write [default: eightfold.zip in the folder that cargo builds in]
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

/// The limit of a 64 kB intro, in bytes.
const LIMIT: usize = 65_536;

/// The text file that comes with the intro.
const NFO: &[u8] = include_bytes!("../eightfold.nfo");

/// The zip library's level for zopfli with 15 iterations, its default: nearly the smallest that deflate can produce, in a second.
const LEVEL: i64 = 24;

/// Unix permissions of the text file: readable by everybody.
const TEXT: u32 = 0o644;
/// Unix permissions of the program: executable by everybody.
const PROGRAM: u32 = 0o755;

/// Builds the intro, checks its size and packs it.
pub fn run(arguments: &Arguments) -> Result<()> {
    let path = match &arguments.intro {
        Some(path) => path.clone(),
        None => cargo::intro()?,
    };
    let program = fs::read(&path).with_context(|| format!("cannot read {}", path.display()))?;
    let size = program.len();
    if size > LIMIT {
        bail!(
            "{} has {size} bytes, {} more than the {LIMIT} that a release takes",
            path.display(),
            size - LIMIT
        );
    }
    let bytes = pack(&[
        ("eightfold", &program, PROGRAM),
        ("eightfold.nfo", NFO, TEXT),
    ])?;
    let out = arguments.out.clone().unwrap_or_else(|| beside(&path));
    output::write(&out, &bytes)?;
    let left = LIMIT - size;
    let sizes = format!(
        "eightfold      {size:>6} bytes, {left} below the limit\neightfold.nfo  {:>6} bytes\n{}: {} bytes\n",
        NFO.len(),
        out.display(),
        bytes.len()
    );
    if out == Path::new("-") {
        eprint!("{sizes}");
        Ok(())
    } else {
        output::write(Path::new("-"), sizes.as_bytes())
    }
}

/// The default path of the zip: in `target` for `target/release/eightfold`.
fn beside(program: &Path) -> PathBuf {
    let folder = program.parent().and_then(Path::parent);
    folder.unwrap_or(Path::new("")).join("eightfold.zip")
}

/// Packs files, given by name, contents and permissions, into a zip.
fn pack(files: &[(&str, &[u8], u32)]) -> Result<Vec<u8>> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for &(name, bytes, permissions) in files {
        // A constant time, the earliest in a zip, so that the same files always give the same zip.
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Deflated)
            .compression_level(Some(LEVEL))
            .last_modified_time(zip::DateTime::DEFAULT)
            .unix_permissions(permissions);
        zip.start_file(name, options)?;
        zip.write_all(bytes)?;
    }
    Ok(zip.finish()?.into_inner())
}
