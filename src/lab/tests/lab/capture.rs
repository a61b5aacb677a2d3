//! `lab capture` writes complete files whose bytes depend on nothing but its arguments.

mod exposure;
mod formats;
#[cfg(target_os = "linux")]
mod interrupted;
mod parts;
mod sound;
mod trouble;

use super::{lab, said};
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::Output;

/// `lab capture` of small frames.
fn capture(arguments: &str) -> Output {
    lab(&line(arguments))
}

/// A command line with defaults: the model scene and small frames.
pub fn line(arguments: &str) -> String {
    let mut defaults = vec![("--size", "48x32"), ("--scene", "model")];
    // Without AVX2 the instruction set has to be named.
    #[cfg(target_arch = "x86_64")]
    if !is_x86_feature_detected!("avx2") {
        defaults.push(("--isa", "sse2"));
    }
    defaults.retain(|(flag, _)| !arguments.contains(flag));
    let defaults = defaults
        .iter()
        .map(|(flag, word)| format!(" {flag} {word}"));
    format!("capture {arguments}{}", defaults.collect::<String>())
}

/// Captures into a file or a folder, which a flag names. Returns what is said of it.
#[track_caller]
fn captured(flag: &str, target: &Path, more: &str) -> String {
    let output = capture(&format!("{flag} {} {more}", target.display()));
    let said = said(&output);
    assert!(output.status.success(), "{more}: {said}");
    said
}

/// The names and contents of a folder's files, sorted by name.
pub fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut files: Vec<(String, Vec<u8>)> = std::fs::read_dir(folder)
        .expect("a folder")
        .map(|entry| entry.expect("an entry"))
        .map(|entry| {
            let name = entry.file_name().into_string().expect("a plain name");
            (name, std::fs::read(entry.path()).expect("a file"))
        })
        .collect();
    files.sort();
    files
}

/// Writes a program that stands for ffmpeg into a folder.
fn write_ffmpeg(folder: &Path, script: &str) {
    write_program(folder, "ffmpeg", script);
}

/// Writes a program of a shell into a folder.
pub fn write_program(folder: &Path, name: &str, script: &str) {
    let file = folder.join(name);
    std::fs::write(&file, format!("#!/bin/sh\n{script}\n")).unwrap();
    std::fs::set_permissions(&file, std::fs::Permissions::from_mode(0o755)).unwrap();
}
