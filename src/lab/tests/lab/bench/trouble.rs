//! Bad input, files that cannot be written and full disks lead to one line of explanation.

use super::number;
use crate::{assert_one_line, cells, command, interrupted, lab};
use serde_json::Value;
use std::mem::take;

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_costs_the_json_but_not_the_table() {
    let mut output = lab("bench --size 8x8 --frames 1 --json /dev/full");
    let table = String::from_utf8(take(&mut output.stdout)).unwrap();
    assert_one_line(&output, 1, &["/dev/full"]);
    assert_eq!(cells(&table).len(), 1 + 3);
}

#[cfg(target_os = "linux")]
#[test]
fn after_a_signal_the_figures_are_those_of_the_frames_until_then() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("bench.json");
    let line = "bench --threads 3 --frames 100000 --size 32x24 --size 48x36 --json";
    let mut output = interrupted(command(line).arg(&file));
    let table = String::from_utf8(take(&mut output.stdout)).unwrap();
    assert_one_line(&output, 130, &["stopped early"]);
    let rows: Vec<Value> = serde_json::from_slice(&std::fs::read(&file).unwrap()).unwrap();
    assert_eq!(rows.len(), 6);
    for row in &rows {
        let frames = number(row, "frames");
        assert!((1.0..100_000.0).contains(&frames), "{row}");
        assert!(
            table.contains(&format!("the first {frames} of 100000 frames")),
            "{table}"
        );
        assert!(
            row["pops"].is_null() && number(row, "ms_median") > 0.0,
            "{row}"
        );
    }
    assert_eq!(cells(&table).len(), 1 + 6);
}
