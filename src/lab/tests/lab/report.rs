//! `lab report` rewrites the marked parts of a file, and nothing else.

use super::{assert_one_line, lab, said};
use eightfold_stage::{needs, reader::read_png};
use std::fs;
use std::path::Path;
use std::process::Output;
use tempfile::TempDir;

const README: &str = "# A title\n\nSaid by hand.\n\n<!-- lab report speed -->\nold\n<!-- lab report end -->\n\nIn between.\n\n\
                      <!-- lab report figures -->\n<!-- lab report end -->\n<!-- lab report sheet -->\n\
                      <!-- lab report end -->\nThe end, without a new line";

/// A page of `docs`. What README.md has too is measured once.
const PAGE: &str = "<!-- lab report ladder --><!-- lab report end -->\n<!-- lab report show -->\n<!-- lab report end -->\n\
                    <!-- lab report sound -->\n<!-- lab report end -->\n\
                    <!-- lab report figures -->\n<!-- lab report end -->\n";

/// A page that nothing is measured for.
const PLAIN: &str = "Nothing marked\n";

/// A folder with these pages.
fn folder(pages: &[(&str, &str)]) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("docs")).unwrap();
    for (name, text) in pages {
        fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

/// The titles of columns that depend on measured times.
const TIMED: [&str; 7] = [
    "fps median",
    "worst second",
    "ms median",
    "ms p99",
    "speed-up",
    "floor",
    "ms",
];

fn report(folder: &Path) -> Output {
    let folder = folder.display();
    lab(&format!("report --folder {folder} --size 64x48 --frames 2"))
}

/// The text without rules and spaces, with all cells of those columns replaced.
fn without_timings(text: &str) -> Vec<String> {
    let mut timed = Vec::new();
    let lines = text.lines().filter(|line| !line.starts_with("| -"));
    lines
        .map(|line| {
            if !line.starts_with('|') {
                timed.clear();
                let end = [", threads ", "Made in "]
                    .iter()
                    .find_map(|said| line.find(said));
                return line[..end.unwrap_or(line.len())].to_owned();
            }
            let cells: Vec<&str> = line.split('|').map(str::trim).collect();
            if timed.is_empty() {
                timed = cells.iter().map(|title| TIMED.contains(title)).collect();
            }
            let cells = cells.iter().zip(&timed);
            let cells = cells.map(|(cell, timed)| if *timed { "timed" } else { *cell });
            cells.collect::<Vec<_>>().join("|")
        })
        .collect()
}

#[test]
#[ignore = "many frames"]
fn the_marked_parts_are_rewritten_and_a_second_time_changes_timings_only() {
    let folder = folder(&[
        ("README.md", README),
        ("docs/page.md", PAGE),
        ("docs/plain.md", PLAIN),
    ]);
    let folder = folder.path();
    let read = |name: &str| fs::read_to_string(folder.join(name)).unwrap();
    let output = report(folder);
    let error = said(&output);
    assert!(
        output.status.success() && output.stdout.is_empty(),
        "{error}"
    );
    assert_eq!(error.matches("cargo lab figures").count(), 1, "{error}");
    let (readme, page) = (read("README.md"), read("docs/page.md"));
    let sheet = || fs::read(folder.join("docs/sheet.png")).unwrap();
    let first_sheet = sheet();

    assert!(!readme.contains("old"));
    for kept in ["# A title\n\nSaid by hand.\n", "\nIn between.\n"] {
        assert!(readme.contains(kept), "{kept}");
    }
    assert!(readme.ends_with("<!-- lab report end -->\nThe end, without a new line"));
    for told in [
        "    cargo lab bench --threads 1",
        "    cargo lab figures --size 64x48\n",
        "    cargo lab capture --size 64x48 --supersample 2 --frames 2 --sheet docs/show.png\n",
        "](docs/show.png)",
        "](docs/sheet.png)",
    ] {
        assert!(readme.contains(told), "{told} is not in {readme}");
    }
    assert!(
        readme
            .lines()
            .any(|line| line.contains("64x48 |") && line.contains(" thesis |"))
    );
    for told in [
        "    cargo lab trade --ladder --size 64x48 --frames 2\n",
        "    cargo lab bench --scene show --size 64x48 --quality default",
        "    cargo lab figures --size 64x48\n",
        "    cargo lab sound --waveform docs/waveform.png\n",
        "Worst second of the show at 64x48",
        " finest | ",
        "](sheet.png)",
        "](waveform.png)",
    ] {
        assert!(page.contains(told), "{told} is not in {page}");
    }
    assert_eq!(read("docs/plain.md"), PLAIN);
    assert!(read_png(&first_sheet).0 > 128);

    // What one page has is enough for a second time.
    fs::write(folder.join("docs/page.md"), PLAIN).unwrap();
    assert!(report(folder).status.success());
    let again = read("README.md");
    assert_eq!(without_timings(&readme), without_timings(&again));
    assert_eq!(first_sheet, sheet());
}

#[test]
fn the_moving_picture_has_all_its_frames_and_begins_again() {
    needs!(&["ffmpeg"]);
    let folder = folder(&[(
        "README.md",
        "<!-- lab report moving -->\n<!-- lab report end -->",
    )]);
    assert!(report(folder.path()).status.success());
    let text = fs::read_to_string(folder.path().join("README.md")).unwrap();
    assert!(text.contains("--video docs/show.webp\n"), "{text}");
    let (picture, command) = (text.find("](docs/show.webp)"), text.find("--video "));
    assert!(picture.is_some() && picture < command, "{text}");
    let bytes = fs::read(folder.path().join("docs/show.webp")).unwrap();
    assert!(bytes.starts_with(b"RIFF") && &bytes[8..12] == b"WEBP");
    let chunks = |name: &[u8; 4]| bytes.windows(4).filter(|word| word == name).count();
    assert_eq!(chunks(b"ANMF"), 2, "frames");
    let animation = bytes.windows(4).position(|word| word == b"ANIM").unwrap();
    // After the chunk's name, its length and the background: how often it is played, 0 for always.
    assert_eq!(bytes[animation + 12..][..2], [0, 0]);
}

#[test]
fn pages_without_marks_are_named_and_stay_as_they_are() {
    for (text, why) in [
        ("nothing", "no page"),
        ("<!-- lab report speed -->", "lab report end"),
        (
            "<!-- lab report speed -->\n<!-- lab report size -->\n<!-- lab report end -->",
            "of its own",
        ),
    ] {
        for name in ["README.md", "docs/page.md"] {
            let folder = folder(&[("README.md", ""), (name, text)]);
            let output = report(folder.path());
            let folder = folder.path();
            assert_one_line(&output, 2, &["--folder", why]);
            assert_eq!(fs::read_to_string(folder.join(name)).unwrap(), text);
        }
    }
    let folder = folder(&[]);
    assert_one_line(&report(folder.path()), 1, &["cannot read", "README.md"]);
}
