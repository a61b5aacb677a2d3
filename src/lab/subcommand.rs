//! Runs commands of this very lab, as somebody would from a terminal.

use crate::{interrupt, output};
use anyhow::{Context, Result, bail};
use std::env;
use std::ffi::{OsStr, OsString};
use std::fs;
use std::io::{Read, Seek};
use std::process::{Command, Stdio};

/// A command that is shown beside what it prints and the pictures that it makes.
pub struct Step {
    pub words: Vec<String>,
    /// The flag by which it is told where to put pictures: a folder by `--out`, the one file by any other.
    pub flag: &'static str,
    /// The pictures that it makes there, and what is said of each.
    pub pictures: &'static [Picture],
}

/// The name of a picture's file, and what it shows.
pub type Picture = (&'static str, &'static str);

/// The picture of `lab figures`.
pub const FIGURES: Picture = (
    "sheet.png",
    "The points traced, the picture, the squares by size, rays of each point, the error",
);
/// Plots of `lab trade`.
pub const FRONT: Picture = (
    "front.svg",
    "Speed and PSNR of every setting, and the Pareto front by number",
);
pub const RESOLUTION: Picture = (
    "resolution.svg",
    "Speed-up against exhaustive frames by the size of the picture",
);
pub const SQUARES: Picture = (
    "squares.svg",
    "PSNR by the side of the squares, 2 to 32 pixels",
);

impl Step {
    /// The step of a command line, with the flag for its pictures.
    pub fn new(command: &str, flag: &'static str, pictures: &'static [Picture]) -> Self {
        Self {
            words: command.split(' ').map(str::to_owned).collect(),
            flag,
            pictures,
        }
    }

    /// The name of the one picture, if its file is told.
    fn told(&self) -> Option<&'static str> {
        match self.pictures {
            [(name, _)] if self.flag != "--out" => Some(name),
            _ => None,
        }
    }

    /// The command as somebody would type it, with its one picture in a folder.
    pub fn shown(&self, folder: &str) -> String {
        let command = format!("cargo lab {}", self.words.join(" "));
        match self.told() {
            Some(name) => format!("{command} {} {folder}{name}", self.flag),
            None => command,
        }
    }

    /// Runs the command. Returns what it prints, and the bytes of its pictures.
    pub fn run(&self) -> Result<(String, Vec<Vec<u8>>)> {
        let made = tempfile::tempdir().context("cannot make a folder for pictures")?;
        let mut words: Vec<OsString> = self.words.iter().map(OsString::from).collect();
        if !self.pictures.is_empty() {
            let out = made.path().join(self.told().unwrap_or_default());
            words.extend([self.flag.into(), out.into()]);
        }
        let printed = run(&words)?;
        let read = |(name, _): &Picture| {
            fs::read(made.path().join(name)).with_context(|| format!("cannot read {name}"))
        };
        let pictures: Result<_> = self.pictures.iter().map(read).collect();
        Ok((printed, pictures?))
    }
}

/// Runs a command, and returns what it prints, without the end of the last line. After [`interrupt::listen`] a signal ends it
/// early, as an error.
fn run<T: AsRef<OsStr>>(arguments: &[T]) -> Result<String> {
    let lab = env::current_exe().context("cannot find the lab")?;
    // A file takes any amount while nobody reads it.
    let mut printed = tempfile::tempfile().context("cannot make a temporary file")?;
    let mut child = Command::new(lab)
        .args(arguments)
        .env(output::QUIET, "1")
        .stdout(printed.try_clone()?)
        .stderr(Stdio::inherit())
        .spawn()
        .context("cannot start the lab")?;
    let status = interrupt::wait(&mut child).context("cannot wait for the lab")?;
    if interrupt::is_stopped() {
        return Err(
            interrupt::Stopped("what was not complete is left as it was".to_owned()).into(),
        );
    }
    if !status.success() {
        let words: Vec<_> = arguments
            .iter()
            .map(|word| word.as_ref().to_string_lossy())
            .collect();
        bail!("cargo lab {} has failed", words.join(" "));
    }
    printed.rewind()?;
    let mut text = String::new();
    printed
        .read_to_string(&mut text)
        .context("the lab printed what is no text")?;
    Ok(text.trim_end().to_owned())
}
