#![cfg(target_arch = "x86_64")]

use eightfold_harness::cargo::Build;
use eightfold_stage::{ended, intro, linked_intro};
use std::{fs, path::Path, process::Command};

/// `linked` is the unpacked program, see `src/pack/build/mod.rs`.
fn assert_is_packed(program: &Path, linked: &Path) {
    let [packed, linked] = [program, linked].map(|path| fs::read(path).expect("a program"));
    assert!(packed.len() <= 65_536, "{} bytes", packed.len());
    let inside = eightfold_pack::unpack_executable(&packed).expect("it is packed");
    let expected = eightfold_pack::strip(&linked).expect("it is a program");
    assert!(inside == expected, "the packed program is another one");
}

#[test]
fn file_has_at_most_64_kib() {
    assert_is_packed(&intro(), &linked_intro());
}

/// `tests/platforms exe` starts cut and damaged files.
#[test]
#[ignore = "the intro for Windows is compiled"]
fn intro_for_windows_has_at_most_64_kib() {
    let build = Build::windows().expect("cargo builds it");
    let linked = build.linked("eightfold").expect("it was linked");
    assert_is_packed(&build.program("eightfold").expect("there is one"), &linked);
}

/// Cuts simulate interrupted downloads, at page borders and elsewhere.
#[test]
fn damaged_or_cut_intro_prints_one_line() {
    // The checksum covers neither the headers nor itself.
    const CHECKED: usize = 400;
    let packed = fs::read(intro()).expect("the intro");
    let folder = tempfile::tempdir().expect("a folder");
    let (source, path) = (folder.path().join("bytes"), folder.path().join("damaged"));
    let assert_damaged = |what: String, bytes: &[u8]| {
        fs::write(&source, bytes).expect("it can be written");
        // Another process copies it: Linux starts no program that a child of another test has open
        // for writing.
        let copied = Command::new("install").args([&source, &path]).status();
        assert!(copied.expect("install is there").success());
        let (code, _, errors) = ended(Command::new(&path).arg("--version"));
        let told = "eightfold: this file is damaged\n";
        assert_eq!((code, &*errors), (Some(1), told), "{what}");
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

#[test]
fn too_little_memory_is_named_in_one_line() {
    let told = "eightfold: memory is below 105 MB\n";
    for (kilobytes, told) in [(80_000, told), (105_000_000_u32.div_ceil(1024), "")] {
        let mut bash = Command::new("bash");
        let limited = format!("ulimit -d {kilobytes}; exec \"$0\" --version");
        let (code, _, errors) = ended(bash.args(["-c", &limited]).arg(intro()));
        assert_eq!((&*errors, code == Some(0)), (told, told.is_empty()), "{kilobytes}");
    }
}

#[test]
fn packed_program_contains_no_paths() {
    let packed = fs::read(intro()).expect("the intro");
    let program = eightfold_pack::unpack_executable(&packed).expect("it is packed");
    let home = std::env::var("HOME").expect("a home");
    for path in [env!("CARGO_MANIFEST_DIR"), &format!("{home}/.cargo"), "/rustc/"] {
        let mut parts = program.windows(path.len());
        assert!(parts.all(|part| part != path.as_bytes()), "{path}");
    }
}
