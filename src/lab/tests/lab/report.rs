//! `lab report` rewrites the marked parts of a file, and nothing else.

use super::{assert_one_line, lab};
use crate::reader::read_png;
use std::fs;
use std::path::Path;
use std::process::Output;

const README: &str = "# A title\n\nSaid by hand.\n\n<!-- lab report speed -->\nold\n<!-- lab report end -->\n\nIn between.\n\n\
                      <!-- lab report ladder --><!-- lab report end -->\n<!-- lab report figures -->\n\
                      <!-- lab report end -->\n<!-- lab report sheet -->\n<!-- lab report end -->\n<!-- lab report show -->\n\
                      <!-- lab report end -->\n<!-- lab report front -->\n<!-- lab report end -->\nThe end, without a new line";

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

fn report(readme: &Path) -> Output {
    let readme = readme.to_str().expect("a plain name");
    let small = ["--size", "64x48", "--frames", "2", "--pictures", "pictures"];
    lab(&[&["report", "--readme", readme], &small[..]].concat())
}

/// The text without rules and spaces, with all cells of those columns replaced.
fn without_timings(text: &str) -> Vec<String> {
    let mut timed = Vec::new();
    let lines = text.lines().filter(|line| !line.starts_with("| -"));
    lines
        .map(|line| {
            if !line.starts_with('|') {
                timed.clear();
                let (line, _) = line.split_once(", threads ").unwrap_or((line, ""));
                return line.to_owned();
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
fn the_marked_parts_are_rewritten_and_a_second_time_changes_timings_only() {
    let folder = tempfile::tempdir().unwrap();
    let readme = folder.path().join("README.md");
    fs::write(&readme, README).unwrap();
    let output = report(&readme);
    let error = String::from_utf8_lossy(&output.stderr);
    assert!(
        output.status.success() && output.stdout.is_empty(),
        "{error}"
    );
    let first = fs::read_to_string(&readme).unwrap();
    let sheet = || fs::read(folder.path().join("pictures/sheet.png")).unwrap();
    let first_sheet = sheet();

    assert!(!first.contains("old"));
    for kept in ["# A title\n\nSaid by hand.\n", "\nIn between.\n"] {
        assert!(first.contains(kept), "{kept}");
    }
    assert!(first.ends_with("<!-- lab report end -->\nThe end, without a new line"));
    for told in [
        "    cargo lab bench --threads 1",
        "    cargo lab trade --ladder --size 64x48 --frames 2\n",
        "    cargo lab trade --quick --size 64x48 --frames 2\n",
        "    cargo lab figures --size 64x48\n",
        "    cargo lab bench --scene show --size 64x48 --quality default",
        "    cargo lab capture --size 64x48 --supersample 2 --frames 2 --sheet pictures/show.png\n",
        "](pictures/show.png)",
        "Worst second of the show at 64x48",
        "| finest | s8 c2 |",
        "](pictures/sheet.png)",
        "](pictures/front.svg)",
    ] {
        assert!(first.contains(told), "{told} is not in {first}");
    }
    assert!(
        first
            .lines()
            .any(|line| line.contains("64x48 |") && line.contains(" thesis |"))
    );
    assert!(read_png(&first_sheet).0 > 128);
    let svg = fs::read_to_string(folder.path().join("pictures/front.svg")).unwrap();
    assert!(svg.trim_end().ends_with("</svg>"));

    assert!(report(&readme).status.success());
    let second = fs::read_to_string(&readme).unwrap();
    assert_eq!(without_timings(&first), without_timings(&second));
    assert_eq!(first_sheet, sheet());
}

#[test]
fn a_file_without_marks_is_named_and_stays_as_it_is() {
    let folder = tempfile::tempdir().unwrap();
    let readme = folder.path().join("README.md");
    for (text, why) in [
        ("nothing", "no part marked"),
        ("<!-- lab report speed -->", "lab report end"),
        (
            "<!-- lab report speed -->\n<!-- lab report size -->\n<!-- lab report end -->",
            "of its own",
        ),
    ] {
        fs::write(&readme, text).unwrap();
        assert_one_line(&report(&readme), 2, &["--readme", "README.md", why]);
        assert_eq!(fs::read_to_string(&readme).unwrap(), text);
    }
    fs::remove_file(&readme).unwrap();
    assert_one_line(&report(&readme), 1, &["cannot read", "README.md"]);
    assert_one_line(
        &lab(&["report", "--frames", "0"]),
        2,
        &["--frames", "from 1"],
    );
    assert_one_line(
        &lab(&["report", "--size", "9"]),
        2,
        &["--size", "WIDTHxHEIGHT"],
    );
}
