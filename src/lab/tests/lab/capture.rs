//! `lab capture`: frames whose bytes depend on nothing but what is asked for, in whole files.

mod formats;
mod parts;
mod sound;
mod trouble;

use super::lab;
use std::path::Path;
use std::process::Output;

/// `lab capture` of small frames.
fn capture(arguments: &str) -> Output {
    lab(&flags(arguments))
}

/// The words of a command line: of the model scene and for small frames, if nothing else is asked for.
fn flags(arguments: &str) -> Vec<&str> {
    let mut words = vec!["capture"];
    words.extend(arguments.split_whitespace());
    if !words.contains(&"--size") {
        words.extend(["--size", "48x32"]);
    }
    if !words.contains(&"--scene") {
        words.extend(["--scene", "model"]);
    }
    // Without AVX2 it asks to be told.
    #[cfg(target_arch = "x86_64")]
    if !is_x86_feature_detected!("avx2") && !words.contains(&"--isa") {
        words.extend(["--isa", "sse2"]);
    }
    words
}

/// Captures into a file or folder, by a flag.
#[track_caller]
fn captured(flag: &str, place: &Path, more: &str) -> Output {
    let place = place.to_str().expect("a plain name");
    let output = capture(&format!("{flag} {place} {more}"));
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{more}: {errors}");
    output
}

/// The names and bytes of a folder's files, in the order of their names.
fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
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
