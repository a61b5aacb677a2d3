//! `lab release`: packs the intro for Linux and for Windows and its text file into a zip.

use crate::{cargo, output};
use anyhow::{Context, Result, bail};
use clap::Args;
use std::fmt::Write as _;
use std::fs;
use std::io::{Cursor, Write};
use std::path::{Path, PathBuf};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

/// Builds the intro for Linux and Windows, checks that both are at most 65,536 bytes, and packs them and their nfo into a zip
///
/// Prints the sizes. The same programs give the same zip, byte for byte.
#[derive(Args)]
pub struct Arguments {
    /// Program for Linux to pack, built before [default: the intro, which is built]
    #[arg(long, value_name = "FILE")]
    intro: Option<PathBuf>,
    /// Program for Windows to pack, built before [default: the intro, which is built]
    #[arg(long, value_name = "FILE")]
    windows: Option<PathBuf>,
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

/// The names of the programs in the zip.
const LINUX: &str = "eightfold";
const WINDOWS: &str = "eightfold.exe";

/// Builds the intro, checks its size and packs it.
pub fn run(arguments: &Arguments) -> Result<()> {
    let path = given_or(&arguments.intro, cargo::intro)?;
    let linux = read(&path)?;
    let windows = read(&given_or(&arguments.windows, cargo::intro_for_windows)?)?;
    let files = [
        (WINDOWS, &*windows, PROGRAM),
        (LINUX, &linux, PROGRAM),
        ("eightfold.nfo", NFO, TEXT),
    ];
    let zip = pack(&files)?;
    let out = arguments.out.clone().unwrap_or_else(|| beside(&path));
    output::write(&out, &zip)?;
    let mut sizes = String::new();
    for (name, bytes, kind) in files {
        let size = bytes.len();
        let left = match kind {
            PROGRAM => format!(", {} below the limit", LIMIT - size),
            _ => String::new(),
        };
        writeln!(sizes, "{name:14} {size:>6} bytes{left}")?;
    }
    writeln!(sizes, "{}: {} bytes", out.display(), zip.len())?;
    if out == Path::new("-") {
        eprint!("{sizes}");
        Ok(())
    } else {
        output::write(Path::new("-"), sizes.as_bytes())
    }
}

/// The path that is given, or that of what is built.
fn given_or(given: &Option<PathBuf>, build: impl Fn() -> Result<PathBuf>) -> Result<PathBuf> {
    given.clone().map_or_else(build, Ok)
}

/// Reads a program that is small enough.
fn read(path: &Path) -> Result<Vec<u8>> {
    let program = fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
    let size = program.len();
    if size > LIMIT {
        bail!(
            "{} has {size} bytes, {} more than the {LIMIT} that a release takes",
            path.display(),
            size - LIMIT
        );
    }
    Ok(program)
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
