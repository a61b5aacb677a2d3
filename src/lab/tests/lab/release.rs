//! `lab release` packs the intro and its text file, which names all flags.

use super::{assert_one_line, lab, printed};
use eightfold_lab::cargo;
use eightfold_stage::{intro, run};
use std::fs;
use std::io::{Cursor, Read};
use std::path::Path;
use std::process::Command;
use zip::ZipArchive;

const NFO: &str = include_str!("../../../../src/eightfold.nfo");

/// The files of a zip: names, permissions and contents.
fn files(zip: &[u8]) -> Vec<(String, u32, Vec<u8>)> {
    let mut zip = ZipArchive::new(Cursor::new(zip)).expect("a zip");
    let files = (0..zip.len()).map(|i| {
        let mut file = zip.by_index(i).expect("a file");
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).expect("its bytes");
        let mode = file.unix_mode().expect("permissions") & 0o777;
        let name = file.name().expect("its name").into_owned();
        (name, mode, bytes)
    });
    files.collect()
}

fn text(path: &Path) -> &str {
    path.to_str().expect("a plain name")
}

#[test]
fn the_intro_for_both_systems_and_its_nfo_are_in_the_zip() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("eightfold.zip");
    let said = printed(&format!("release --out {}", out.display()));
    let intro = fs::read(intro()).unwrap();
    let windows = fs::read(cargo::intro_for_windows().unwrap()).unwrap();
    let zip = fs::read(&out).unwrap();
    for size in [intro.len(), windows.len(), NFO.len(), zip.len()] {
        assert!(said.contains(&format!(" {size} bytes")), "{size}: {said}");
    }
    assert!(intro.starts_with(b"\x7fELF") && windows.starts_with(b"MZ"));
    let files = files(&zip);
    let wanted = [
        ("eightfold.exe".to_owned(), 0o755, windows),
        ("eightfold".to_owned(), 0o755, intro),
        ("eightfold.nfo".to_owned(), 0o644, NFO.into()),
    ];
    assert!(files == wanted);
    assert!(
        zip.len() < files.iter().map(|(_, _, bytes)| bytes.len()).sum(),
        "the nfo is deflated, what is packed stays as it is"
    );
}

#[test]
fn a_program_over_the_limit_is_no_release() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name| folder.path().join(name);
    let (linux, windows, out) = (path("linux"), path("windows"), path("out.zip"));
    let release = || {
        let names = [&out, &linux, &windows].map(|path| text(path));
        let [out, linux, windows] = names;
        lab(&format!(
            "release --out {out} --intro {linux} --windows {windows}"
        ))
    };
    for program in [&linux, &windows] {
        fs::write(&linux, vec![7; 65_536]).unwrap();
        fs::write(&windows, vec![8; 65_536]).unwrap();
        fs::write(program, vec![7; 65_537]).unwrap();
        let words = [text(program), "65537 bytes", "1 more than the 65536"];
        assert_one_line(&release(), 1, &words);
        assert!(!out.exists());
    }
    fs::write(&windows, vec![8; 65_536]).unwrap();
    let output = release();
    assert!(output.status.success());
    let zip = fs::read(&out).unwrap();
    assert_eq!(files(&zip)[0].2, vec![8; 65_536]);
    assert_eq!(files(&zip)[1].2, vec![7; 65_536]);
    assert!(release().status.success() && zip == fs::read(&out).unwrap());
    fs::remove_file(&windows).unwrap();
    assert_one_line(&release(), 1, &["cannot read", "windows"]);
}

/// The first word of each line that begins with `--`.
fn flags(text: &str) -> Vec<&str> {
    let words = text
        .lines()
        .filter_map(|line| line.split_whitespace().next());
    let mut flags: Vec<&str> = words.filter(|word| word.starts_with("--")).collect();
    // A line of hyphens alone is not a flag.
    flags.retain(|flag| flag.contains(char::is_alphabetic));
    flags.sort_unstable();
    flags
}

#[test]
fn the_nfo_tells_every_flag_and_key_that_the_intro_knows() {
    let (output, help) = run(Command::new(intro()).arg("--help"));
    assert!(output.status.success());
    assert!(flags(&help).len() > 10, "{help}");
    assert_eq!(flags(NFO), flags(&help));
    let keys = help.lines().find_map(|line| line.strip_prefix("keys: "));
    for key in keys.expect("keys").split(", ") {
        let (key, does) = key.split_once(' ').expect("what it does");
        let is_told = |line: &str| {
            let mut words = line.split_whitespace();
            words.next() == Some(key) && line.ends_with(does)
        };
        assert!(NFO.lines().any(is_told), "{key} {does}");
    }
}

#[test]
fn the_nfo_is_for_every_terminal() {
    for line in NFO.lines() {
        assert!(line.len() <= 80, "{line}");
        let plain = line.bytes().all(|byte| (b' '..=b'~').contains(&byte));
        assert!(plain && line.trim_end() == line, "{line}");
    }
    for name in ["Heaven Seven", "RealStorm", "thesis", "2008"] {
        assert!(NFO.contains(name), "{name}");
    }
}
