//! Both files have at most 65,536 bytes, as `cargo build --release` and `cargo exe` pack them.

use eightfold_lab::cargo::Build;
use std::{
    fs,
    path::{Path, PathBuf},
    process::{Command, Output},
    sync::LazyLock,
};

struct Intro {
    program: PathBuf,
    /// The program as it was linked, see `src/pack/build/mod.rs`.
    linked: PathBuf,
}

impl Intro {
    fn of(build: Build) -> Intro {
        Intro {
            program: build.program("eightfold").expect("there is a program"),
            linked: build.linked("eightfold").expect("it was linked"),
        }
    }
}

fn intro() -> &'static Intro {
    static INTRO: LazyLock<Intro> =
        LazyLock::new(|| Intro::of(Build::release("eightfold").expect("cargo builds the intro")));
    &INTRO
}

fn read(path: &Path) -> Vec<u8> {
    fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn run(program: &Path, argument: &str) -> Output {
    let mut command = Command::new(program);
    command.arg(argument).output().expect("it starts")
}

fn assert_is_packed(intro: &Intro) {
    let packed = read(&intro.program);
    assert!(packed.len() <= 65_536, "{} bytes", packed.len());
    let inside = eightfold_pack::unpack_executable(&packed).expect("it is packed");
    let expected = eightfold_pack::strip(&read(&intro.linked)).expect("it is a program");
    assert!(inside == expected, "the packed program is another one");
}

#[test]
fn file_has_at_most_64_kib() {
    assert_is_packed(intro());
}

/// `tests/platforms` starts cut and damaged files in Wine.
#[test]
#[ignore = "the intro for Windows is compiled"]
fn intro_for_windows_has_at_most_64_kib() {
    let intro = Intro::of(Build::windows().expect("cargo builds it"));
    assert_is_packed(&intro);
    // The checksum does not cover headers and addresses of Windows functions.
    const CHECKED: usize = 800;
    let packed = read(&intro.program);
    let end = packed.iter().rposition(|&byte| byte != 0).expect("bytes") + 1;
    let unpacks = |bytes: &[u8]| eightfold_pack::unpack_executable(bytes).is_ok();
    for place in (CHECKED..end).step_by(997).chain([end - 1]) {
        let mut damaged = packed.clone();
        damaged[place] ^= 1;
        assert!(!unpacks(&damaged), "byte {place}");
        assert!(!unpacks(&packed[..place]), "{place} bytes");
    }
}

/// Cuts simulate interrupted downloads, at page borders and elsewhere.
#[test]
fn damaged_or_cut_intro_says_so() {
    // The checksum covers neither the headers nor itself.
    const CHECKED: usize = 400;
    let packed = read(&intro().program);
    let folder = tempfile::tempdir().expect("a folder");
    let (source, path) = (folder.path().join("bytes"), folder.path().join("damaged"));
    let assert_damaged = |what: String, bytes: &[u8]| {
        fs::write(&source, bytes).expect("it can be written");
        // Copied by another process: Linux does not start a program while a child that another test has forked has it open for
        // writing.
        let copied = Command::new("install").args([&source, &path]).status();
        assert!(copied.expect("install is there").success());
        let output = run(&path, "--version");
        assert_eq!(output.status.code(), Some(1), "{what}: {output:?}");
        let errors = String::from_utf8_lossy(&output.stderr);
        assert_eq!(errors, "eightfold: this file is damaged\n", "{what}");
    };
    let (middle, last) = (packed.len() / 2, packed.len() - 1);
    for place in (CHECKED..5000).step_by(460).chain([middle, last]) {
        let mut damaged = packed.clone();
        damaged[place] ^= 1;
        assert_damaged(format!("byte {place}"), &damaged);
    }
    let last_page = last / 4096 * 4096;
    for length in [CHECKED, 1000, 4095, 4096, 4097, middle, last_page, last] {
        assert_damaged(format!("{length} bytes"), &packed[..length]);
    }
}

/// Linux kills a program silently if its headers ask for more memory than it may have.
#[test]
fn too_little_memory_is_named_in_one_line() {
    let told = "eightfold: memory is below 105 MB\n";
    for (kilobytes, told) in [(80_000, told), (105_000_000_u32.div_ceil(1024), "")] {
        let mut bash = Command::new("bash");
        let limited = format!("ulimit -d {kilobytes}; exec \"$0\" --version");
        let output = bash.args(["-c", &limited]).arg(&intro().program).output();
        let output = output.expect("bash is there");
        assert_eq!(String::from_utf8_lossy(&output.stderr), told);
        assert_eq!(output.status.success(), told.is_empty(), "{kilobytes}");
    }
}

#[test]
fn packed_program_contains_no_paths() {
    let program = eightfold_pack::unpack_executable(&read(&intro().program)).expect("it is packed");
    let home = std::env::var("HOME").expect("a home");
    for path in [
        env!("CARGO_MANIFEST_DIR"),
        &format!("{home}/.cargo"),
        "/rustc/",
    ] {
        let mut parts = program.windows(path.len());
        assert!(parts.all(|part| part != path.as_bytes()), "{path}");
    }
}
