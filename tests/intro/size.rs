//! The intro's size: at most 65,536 bytes as `cargo build --release` and, for Windows, `cargo exe` leave it, packed.

use std::{fs, path::Path, path::PathBuf, process::Command, sync::OnceLock};

use eightfold_lab::cargo::Build;

/// The largest file of a 64 kB intro, where a kB is 1,024 bytes; where it is 1,000, [`AIM`] is.
const LIMIT: usize = 65_536;
const AIM: usize = 64_000;

/// The result of a build.
struct Intro {
    program: PathBuf,
    /// The same program as it was linked, see `src/pack/build/mod.rs`.
    linked: PathBuf,
}

impl Intro {
    fn build(variables: &[(&str, &str)]) -> Intro {
        Intro::of(Build::release_with("eightfold", variables).expect("cargo builds the intro"))
    }

    fn of(build: Build) -> Intro {
        Intro {
            program: build.program("eightfold").expect("there is a program"),
            linked: build.linked("eightfold").expect("it was linked"),
        }
    }
}

/// The intro, as `cargo run --release` builds it.
fn intro() -> &'static Intro {
    static INTRO: OnceLock<Intro> = OnceLock::new();
    INTRO.get_or_init(|| Intro::build(&[]))
}

/// The intro for Windows, as `cargo exe` builds it.
fn intro_for_windows() -> &'static Intro {
    static INTRO: OnceLock<Intro> = OnceLock::new();
    INTRO.get_or_init(|| Intro::of(Build::windows().expect("cargo builds the intro for Windows")))
}

fn both() -> [&'static Intro; 2] {
    [intro(), intro_for_windows()]
}

fn read(path: &Path) -> Vec<u8> {
    fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn the_intro_is_at_most_64_kib() {
    for intro in both() {
        let (name, size) = (intro.program.display(), read(&intro.program).len());
        println!("{name}: {size} bytes, {} left", LIMIT as i64 - size as i64);
        assert!(size <= LIMIT, "{size} bytes are more than {LIMIT}");
        if size > AIM {
            eprintln!("warning: {name} has more than {AIM} bytes, which 64 kB are, too: {size}");
        }
    }
}

/// The page's figures are of builds that were much like these.
#[test]
fn the_page_tells_the_size() {
    // The file for Windows grows by so many bytes at a time.
    const NEAR: usize = 512;
    let page = include_str!("../../docs/size.md");
    let rows = page
        .lines()
        .filter_map(|line| line.strip_prefix("| **the file** | | **"));
    let told: Vec<usize> = rows
        .map(|row| row.split('*').next().and_then(|size| size.parse().ok()))
        .map(|size| size.expect("a number"))
        .collect();
    let sizes = both().map(|intro| read(&intro.program).len());
    assert_eq!(told.len(), sizes.len());
    for (told, size) in told.into_iter().zip(sizes) {
        assert!(
            told.abs_diff(size) <= NEAR,
            "the page tells of {told} bytes, not {size}"
        );
    }
}

#[test]
fn the_packed_intro_runs() {
    let output = Command::new(&intro().program)
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
    for intro in both() {
        let inside = eightfold_pack::unpack_executable(&read(&intro.program));
        let expected = eightfold_pack::strip(&read(&intro.linked)).expect("it is a program");
        let inside = inside.expect("it is packed");
        assert!(inside == expected, "the packed program is another one");
    }
}

/// That Windows does not start a file that was cut, and that a damaged one says so, is tried by `tests/platforms`.
#[test]
fn a_damaged_or_cut_intro_for_windows_is_not_unpacked() {
    let packed = read(&intro_for_windows().program);
    let end = packed.iter().rposition(|&byte| byte != 0).expect("bytes") + 1;
    for place in (UNCHECKED_FOR_WINDOWS..end).step_by(997).chain([end - 1]) {
        let mut damaged = packed.clone();
        damaged[place] ^= 1;
        assert!(
            eightfold_pack::unpack_executable(&damaged).is_err(),
            "byte {place}"
        );
        assert!(
            eightfold_pack::unpack_executable(&packed[..place]).is_err(),
            "{place} bytes"
        );
    }
}

/// The first bytes of the file, which nobody checks: headers, and what checks all others.
const UNCHECKED: usize = 400;
/// The same for Windows, where addresses of its functions are among them.
const UNCHECKED_FOR_WINDOWS: usize = 800;

/// Runs a file of these bytes, which has to say that it is damaged.
fn assert_damaged(what: &str, bytes: &[u8]) {
    let folder = tempfile::tempdir().expect("a folder");
    let (source, path) = (folder.path().join("bytes"), folder.path().join("damaged"));
    fs::write(&source, bytes).expect("it can be written");
    // By a process of its own: a program cannot be started while a process that another test forks has it open for writing.
    let copied = Command::new("install").args([&source, &path]).status();
    assert!(copied.expect("install is there").success());
    let output = Command::new(&path).output().expect("it starts");
    assert_eq!(output.status.code(), Some(1), "{what}: {output:?}");
    assert_eq!(
        output.stderr, b"eightfold: this file is damaged\n",
        "{what}"
    );
}

#[test]
fn a_damaged_intro_says_so() {
    let packed = read(&intro().program);
    // The stub from its beginning on, then what is packed.
    let places = (UNCHECKED..5000).step_by(460);
    for place in places.chain([packed.len() / 2, packed.len() - 1]) {
        let mut damaged = packed.clone();
        damaged[place] ^= 1;
        assert_damaged(&format!("byte {place}"), &damaged);
    }
}

/// As a download that was interrupted is, by pages that are not there and by others that end in zeros.
#[test]
fn a_cut_intro_says_so() {
    let packed = read(&intro().program);
    let last_page = (packed.len() - 1) / 4096 * 4096;
    for length in [
        UNCHECKED,
        1000,
        4095,
        4096,
        4097,
        8192,
        packed.len() / 2,
        last_page,
        last_page + 1,
        packed.len() - 1,
    ] {
        assert_damaged(&format!("{length} bytes"), &packed[..length]);
    }
}

/// Without a word Linux would end a program that has more memory in its headers than it may have.
#[test]
fn too_little_memory_is_told_in_one_line() {
    let program = &intro().program;
    for (kilobytes, told) in [
        (20_000, "eightfold: there are no 105 MB of memory for it\n"),
        (80_000, "eightfold: there are no 105 MB of memory for it\n"),
        (105_000_000_u32.div_ceil(1024), ""),
    ] {
        let mut bash = Command::new("bash");
        let limited = format!("ulimit -d {kilobytes}; exec \"$0\" --version");
        let output = bash.args(["-c", &limited]).arg(program).output();
        let output = output.expect("bash is there");
        assert_eq!(String::from_utf8_lossy(&output.stderr), told);
        assert_eq!(output.status.success(), told.is_empty(), "{kilobytes}");
    }
}

/// No path is in the file, and nothing of chance; `EIGHTFOLD_UNPACKED` leaves out the packing and nothing else.
#[test]
#[ignore = "the intro is compiled in another folder"]
fn another_folder_has_the_same_bytes_packed_and_unpacked() {
    let folder = tempfile::tempdir().expect("a folder");
    let target = (
        "CARGO_TARGET_DIR",
        folder.path().to_str().expect("its name is UTF-8"),
    );
    let packed = read(&Intro::build(&[target]).program);
    assert!(packed == read(&intro().program), "the builds differ");
    let unpacked = Intro::build(&[target, ("EIGHTFOLD_UNPACKED", "1")]);
    let program = read(&unpacked.program);
    assert!(
        program == read(&intro().linked),
        "the unpacked program is another one"
    );
    let names = program
        .windows(15)
        .filter(|name| *name == b"eightfold_abort");
    assert!(names.count() > 0, "the unpacked program has no symbols");
    let output = Command::new(&unpacked.program).arg("--version").output();
    assert!(output.expect("it starts").status.success());
}
