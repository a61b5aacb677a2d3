//! A simulated sound device and clock; builds `libasound.rs`.

use std::{
    env, fs,
    path::{Path, PathBuf},
    process::{Command, Output},
};

/// Chunks of samples, and the nanosecond from which each is heard.
pub type Played = Vec<(u64, Vec<[f32; 2]>)>;

pub fn build(folder: &Path) -> PathBuf {
    let library = folder.join("libasound.so.2");
    let source = folder.join("libasound.rs");
    fs::write(&source, include_str!("libasound.rs")).expect("a file");
    let status = Command::new(env::var_os("RUSTC").unwrap_or("rustc".into()))
        .args(["--edition", "2024", "--crate-type", "cdylib", "-O", "-o"])
        .arg(&library)
        .arg(source)
        .status()
        .expect("rustc starts");
    assert!(status.success(), "the simulated library can be built");
    library
}

pub fn run(library: &Path, program: &mut Command) -> (Output, Played) {
    let file = library.with_extension("played");
    let output = program
        .env("LD_PRELOAD", library)
        .env("LD_LIBRARY_PATH", library.parent().expect("a folder"))
        .env("SIMULATED_FILE", &file)
        .output()
        .expect("the program starts");
    let bytes = fs::read(&file).expect("what was played");
    /// Bytes of a time, and of a chunk of 48 samples.
    const TIME: usize = 8;
    const CHUNK: usize = 48 * 8;
    let sides = |bytes: &[u8]| {
        [0, 4].map(|at| f32::from_le_bytes(bytes[at..at + 4].try_into().expect("four bytes")))
    };
    let chunks = bytes.chunks_exact(TIME + CHUNK).map(|bytes| {
        let (time, chunk) = bytes.split_at(TIME);
        let time = u64::from_le_bytes(time.try_into().expect("eight bytes"));
        (time, chunk.chunks_exact(8).map(sides).collect())
    });
    (output, chunks.collect())
}
