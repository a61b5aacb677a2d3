//! `lab capture` writes complete files whose bytes depend on nothing but its arguments.

mod exposure;
mod formats;
#[cfg(target_os = "linux")]
mod interrupted;
mod parts;
mod sound;
mod trouble;

use super::lab;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::Output;

/// `lab capture` of small frames.
fn capture(arguments: &str) -> Output {
    lab(&flags(arguments))
}

/// The words of a command line, with defaults: the model scene and small frames.
pub fn flags(arguments: &str) -> Vec<&str> {
    let mut words = vec!["capture"];
    words.extend(arguments.split_whitespace());
    if !words.contains(&"--size") {
        words.extend(["--size", "48x32"]);
    }
    if !words.contains(&"--scene") {
        words.extend(["--scene", "model"]);
    }
    // Without AVX2 the instruction set has to be named.
    #[cfg(target_arch = "x86_64")]
    if !is_x86_feature_detected!("avx2") && !words.contains(&"--isa") {
        words.extend(["--isa", "sse2"]);
    }
    words
}

/// Captures into a file or a folder, which a flag names.
#[track_caller]
fn captured(flag: &str, target: &Path, more: &str) -> Output {
    let target = target.to_str().expect("a plain name");
    let output = capture(&format!("{flag} {target} {more}"));
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{more}: {errors}");
    output
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
