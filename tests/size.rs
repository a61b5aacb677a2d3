//! The intro's size: at most 65,536 bytes as `cargo build --release` leaves it, packed.

use std::{
    fs,
    path::{Path, PathBuf},
    process::Command,
    sync::OnceLock,
};

/// The largest file of a 64 kB intro, where a kB is 1,024 bytes; where it is 1,000, [`AIM`] is.
const LIMIT: usize = 65_536;
const AIM: usize = 64_000;

/// What a build has made.
struct Build {
    program: PathBuf,
    /// The same program as it was linked, see `src/pack/build/mod.rs`.
    unpacked: PathBuf,
}

/// The intro, as `cargo run --release` builds it.
fn build() -> &'static Build {
    static BUILD: OnceLock<Build> = OnceLock::new();
    BUILD.get_or_init(|| build_in(None))
}

/// Builds the intro, in a folder of its own if one is given.
fn build_in(target: Option<&Path>) -> Build {
    let mut cargo = Command::new(env!("CARGO"));
    cargo
        .args(["build", "--release", "--package", "eightfold"])
        .args(["--bin", "eightfold", "--message-format", "json"])
        .current_dir(env!("CARGO_MANIFEST_DIR"));
    if let Some(target) = target {
        cargo.env("CARGO_TARGET_DIR", target);
    }
    let output = cargo.output().expect("cargo runs");
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    let messages = String::from_utf8_lossy(&output.stdout);
    let messages: Vec<serde_json::Value> = messages
        .lines()
        .filter_map(|line| serde_json::from_str(line).ok())
        .collect();
    let program = messages
        .iter()
        .rfind(|message| message["executable"].is_string())
        .expect("cargo says what it has built");
    let script = messages
        .iter()
        .rfind(|message| {
            message["reason"] == "build-script-executed"
                && message["package_id"] == program["package_id"]
        })
        .expect("cargo says where the build script wrote");
    let path = |value: &serde_json::Value| PathBuf::from(value.as_str().expect("a path"));
    Build {
        program: path(&program["executable"]),
        unpacked: path(&script["out_dir"]).join("eightfold.unpacked"),
    }
}

#[test]
fn the_intro_is_at_most_64_kib() {
    let size = fs::read(&build().program)
        .expect("the intro can be read")
        .len();
    println!("{size} bytes, {} left", LIMIT as i64 - size as i64);
    assert!(size <= LIMIT, "{size} bytes are more than {LIMIT}");
    if size > AIM {
        eprintln!("warning: {size} bytes are more than {AIM}, which 64 kB are, too");
    }
}

#[test]
fn the_packed_intro_runs() {
    let output = Command::new(&build().program)
        .arg("--version")
        .output()
        .expect("the intro starts");
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{output:?}");
    assert_eq!(
        said.trim(),
        concat!("eightfold ", env!("CARGO_PKG_VERSION"))
    );
}

#[test]
fn what_was_linked_is_what_is_packed() {
    let packed = fs::read(&build().program).expect("the intro can be read");
    let linked = fs::read(&build().unpacked).expect("the linked program can be read");
    let inside = eightfold_pack::unpack_executable(&packed).expect("it is packed");
    let expected = eightfold_pack::strip(&linked).expect("it is a program");
    assert!(inside == expected, "the packed program is another one");
}

#[test]
fn a_damaged_intro_says_so() {
    let mut packed = fs::read(&build().program).expect("the intro can be read");
    let last = packed.last_mut().expect("a byte");
    *last ^= 1;
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("damaged");
    fs::copy(&build().program, &path).expect("it can be copied, with its permissions");
    fs::write(&path, packed).expect("it can be written");
    let output = Command::new(&path).output().expect("it starts");
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(output.stderr, b"eightfold: this file is damaged\n");
}

/// In another folder, so that no path of it is in the file.
#[test]
fn two_builds_make_the_same_bytes() {
    let folder = tempfile::tempdir().expect("a folder");
    let again = build_in(Some(folder.path()));
    let read = |build: &Build| fs::read(&build.program).expect("the intro can be read");
    assert!(read(build()) == read(&again), "the builds differ");
}
