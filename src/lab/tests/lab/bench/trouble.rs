//! Bad input, files that cannot be written and full disks lead to one line of explanation.

use super::cells;
use crate::{assert_one_line, lab};
use eightfold::Quality;

#[test]
fn bad_input_is_named_in_one_line() {
    let qualities = format!("exhaustive, thesis, {}", Quality::NAMES.join(", "));
    for (flag, value, takes) in [
        ("--size", "0x5", "WIDTHxHEIGHT"),
        ("--size", "4000x10", "3840x2160"),
        ("--threads", "0", "from 1"),
        ("--quality", "best", &qualities),
        ("--frames", "0", "from 1 to"),
        ("--frames", "1.5", "from 1 to"),
        ("--frames", "100001", "to 100000"),
        ("--time-from", "inf", "seconds"),
        ("--time-to", "soon", "seconds"),
        ("--scene", "field:0", "field:N"),
        ("--isa", "mmx", "this machine has"),
    ] {
        assert_one_line(&lab(&["bench", flag, value]), 2, &[flag, value, takes]);
    }
    let backwards = ["bench", "--time-from", "5", "--time-to", "1"];
    assert_one_line(&lab(&backwards), 2, &["--time-to", "--time-from"]);
    assert_one_line(&lab(&["bench", "--json"]), 2, &["--json"]);
    assert_one_line(&lab(&["bench", "--json", ""]), 2, &["--json"]);
    assert_one_line(&lab(&["bench", "--time", "1"]), 2, &["--time"]);
}

#[test]
fn a_file_that_cannot_be_written_is_named_before_anything_is_measured() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["missing/bench.json", "."] {
        let file = folder.path().join(name);
        let file = file.to_str().expect("a plain name");
        // So many frames would take far too long.
        let output = lab(&["bench", "--frames", "100000", "--json", file]);
        assert_one_line(&output, 1, &["cannot write", file]);
    }
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_costs_the_json_but_not_the_table() {
    let output = lab(&[
        "bench",
        "--size",
        "8x8",
        "--frames",
        "1",
        "--json",
        "/dev/full",
    ]);
    assert_eq!(output.status.code(), Some(1));
    let text = String::from_utf8_lossy(&output.stderr);
    assert!(
        text.lines().count() == 1 && text.contains("/dev/full"),
        "{text}"
    );
    assert_eq!(cells(&String::from_utf8_lossy(&output.stdout)).len(), 1 + 3);
}
