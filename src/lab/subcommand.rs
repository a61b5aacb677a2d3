//! Runs commands of this very lab, as somebody would from a terminal.

use crate::{interrupt, output};
use anyhow::{Context, Result, bail};
use std::env;
use std::ffi::OsStr;
use std::io::{Read, Seek};
use std::process::{Command, Stdio};

/// Runs a command, and returns what it prints, without the end of the last line. After [`interrupt::listen`] a signal ends it
/// early, as an error.
pub fn run<T: AsRef<OsStr>>(arguments: &[T]) -> Result<String> {
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
