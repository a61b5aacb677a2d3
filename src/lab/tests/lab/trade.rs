//! `lab trade` writes all its files, and its figures are consistent. No test depends on measured times.

use super::{assert_one_line, lab, printed};
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

const PLOTS: [&str; 7] = [
    "front",
    "front-flip",
    "front-pops",
    "squares",
    "resolution",
    "objects",
    "over-time",
];

/// Runs `lab trade` with very small frames; it writes to a folder.
fn trade(folder: &Path) -> String {
    trade_at("48x36", folder, "")
}

/// The same with another size.
#[track_caller]
fn trade_at(size: &str, folder: &Path, more: &str) -> String {
    let folder = folder.display();
    printed(&format!(
        "trade --quick --size {size} --frames 2 --out {folder} {more}"
    ))
}

fn json(folder: &Path) -> Value {
    serde_json::from_slice(&fs::read(folder.join("trade.json")).unwrap()).expect("JSON")
}

/// Asserts that the folder has all files of a trade, complete, with the given plots and nothing else.
#[track_caller]
fn assert_whole(folder: &Path, plots: &[&str]) {
    let mut expected = BTreeSet::from(["trade.json".to_owned()]);
    for plot in plots {
        let svg = fs::read_to_string(folder.join(format!("{plot}.svg"))).unwrap();
        assert!(
            svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"),
            "{plot}"
        );
        assert!(svg.contains("<text"), "{plot} says nothing");
        expected.insert(format!("{plot}.svg"));
    }
    let files = fs::read_dir(folder).unwrap();
    let files = files.map(|file| {
        file.unwrap()
            .file_name()
            .into_string()
            .expect("a plain name")
    });
    assert_eq!(files.collect::<BTreeSet<_>>(), expected);
}

#[test]
fn all_that_is_measured_is_written_whole() {
    let folder = tempfile::tempdir().unwrap();
    let table = trade(folder.path());
    assert!(table.contains("| quality | dials |") && table.contains("48x36"));
    assert_whole(folder.path(), &PLOTS);

    let json = json(folder.path());
    assert_eq!(json["complete"], true);
    let rows = json["points"].as_array().expect("rows");
    let have = |key: &str, value: f64| rows.iter().any(|row| row[key].as_f64() == Some(value));
    for square in [1, 2, 4, 8, 16, 32] {
        assert!(have("square", square.into()), "squares of {square}");
    }
    for depth in 0..=7 {
        assert!(have("depth", depth.into()), "depth {depth}");
    }
    for (key, values) in [
        ("key_depth", vec![0.0, 1.0, 2.0]),
        ("state_depth", vec![0.0, 1.0, 5.0]),
        ("least_contribution", vec![0.0, 0.1]),
        ("tolerance_differing", vec![1.0, 64.0]),
        ("highlight", vec![0.25, 1.0 / 64.0]),
    ] {
        for value in values {
            assert!(have(key, value), "{key} {value}");
        }
    }
    assert!(rows.iter().any(|row| row["guarded"] == false));
    for row in rows {
        for key in ["speedup", "flip_mean", "flip_p99", "pops", "pixels_over_8"] {
            assert!(
                row[key].as_f64().is_some_and(|n| n >= 0.0),
                "{key} of {row}"
            );
        }
    }
    let exhaustive = &rows[0];
    assert_eq!(exhaustive["name"], "exhaustive");
    assert!(exhaustive["psnr_db"].is_null());
    assert_eq!(exhaustive["flip_mean"], 0.0);
    assert_eq!(exhaustive["pops"], 0.0);
    assert_eq!(json["views"].as_array().map(Vec::len), Some(9));
}

#[test]
fn no_point_of_the_front_is_beaten_by_another() {
    let folder = tempfile::tempdir().unwrap();
    // In such small pictures no quality is much faster than tracing every pixel.
    trade_at("256x192", folder.path(), "--views 1");
    let json = json(folder.path());
    let rows = json["points"].as_array().expect("rows");
    // Those that keep the rules of the product: colours, objects and states of the lights agree, and nothing is missed.
    let keeps_the_rules = |row: &&Value| {
        let compares = row["keys"] == true && row["tolerance_differing"] == 0.0;
        let guarded = row["guarded"] == true && row["missed_objects"] == 0.0;
        guarded && (compares || row["square"] == 1)
    };
    let costs = |row: &Value| {
        let cost = |key: &str| row[key].as_f64().expect("a number");
        [-cost("speedup"), cost("flip_mean"), cost("pops")]
    };
    for row in rows.iter().filter(keeps_the_rules) {
        let mut others = rows.iter().filter(keeps_the_rules);
        let is_beaten = others.any(|other| {
            let pairs = || costs(other).into_iter().zip(costs(row));
            pairs().all(|(other, own)| other <= own) && pairs().any(|(other, own)| other < own)
        });
        assert_eq!(row["on_front"], !is_beaten, "{row}");
    }
    let mut others = rows.iter().filter(|row| !keeps_the_rules(row));
    assert!(others.all(|row| row["on_front"] == false));
    assert!(rows.iter().filter(|row| row["on_front"] == true).count() > 2);
}

#[test]
fn errors_are_those_that_bench_measures() {
    let frames = "--size 64x48 --frames 3 --time-from 1 --time-to 5";
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().display();
    printed(&format!("trade --quick --out {out} {frames}"));
    let json = json(folder.path());
    let bench = printed(&format!(
        "bench --jagged --quality default --json - {frames}"
    ));
    let bench: Vec<Value> = serde_json::from_str(&bench).expect("JSON");
    let mut points = json["points"].as_array().expect("rows").iter();
    let row = points
        .find(|row| row["name"] == "default")
        .expect("the default");
    for key in [
        "traced_fraction",
        "psnr_db",
        "psnr_worst_db",
        "pixels_over_8",
        "pops",
        "flip_mean",
        "flip_p99",
    ] {
        let pair = [row, &bench[1]].map(|row| row[key].as_f64().expect("a number"));
        assert!((pair[0] - pair[1]).abs() < 1e-9, "{key}: {pair:?}");
    }
}

#[cfg(unix)]
#[test]
fn what_is_done_before_a_signal_is_written_whole() {
    for (signal, code) in [("INT", 130), ("TERM", 143), ("HUP", 129)] {
        assert_ends_early(signal, code);
    }
}

#[cfg(unix)]
fn assert_ends_early(signal: &str, code: i32) {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("trade");
    // So many frames would take far too long.
    let lab = Command::new(env!("CARGO_BIN_EXE_lab"))
        .args([
            "trade", "--quick", "--size", "48x36", "--frames", "100000", "--out",
        ])
        .arg(&out)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // By then the command heeds signals.
    while !out.exists() {
        std::thread::yield_now();
    }
    let kill = format!("kill -{signal} {}", lab.id());
    let status = Command::new("sh").args(["-c", &kill]).status();
    assert!(status.unwrap().success());
    let mut output = lab.wait_with_output().unwrap();
    let table = String::from_utf8(std::mem::take(&mut output.stdout)).expect("text");
    assert_one_line(
        &output,
        code,
        &["stopped early", out.to_str().expect("a plain name")],
    );
    assert!(table.contains("stopped early"));
    assert_whole(&out, &["front", "squares", "over-time"]);
    let json = json(&out);
    assert_eq!(json["complete"], false);
    for row in json["points"].as_array().expect("rows") {
        let frames = row["frames"].as_u64().expect("a number");
        assert!((1..100_000).contains(&frames));
        assert!(row["flip_mean"].is_null() && row["pops"].is_null());
    }
}

#[test]
fn all_rows_are_antialiased_if_that_was_asked_for() {
    let table = printed("trade --ladder --size 48x36 --frames 2 --views 2 --antialias");
    let rows: Vec<&str> = table.lines().filter(|line| line.contains(" a |")).collect();
    assert_eq!(rows.len(), 9, "{table}");
    // The exhaustive frames, which serve as reference, are antialiased, too.
    let exhaustive = rows[0];
    assert!(exhaustive.starts_with("| exhaustive | s1 a |"), "{table}");
    assert!(exhaustive.contains("| - | - | 0 | 0 |"), "{table}");
    assert!(
        !exhaustive.contains("100.0 %"),
        "more than a point a pixel: {table}"
    );
}

#[test]
fn an_empty_table_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().expect("a plain name");
    let few = "trade --scene show --quick --frames 1 --size 32x24 --out".split(' ');
    let output = lab(&few.chain([out]).collect::<Vec<_>>());
    assert_one_line(&output, 1, &["no setting", "--size"]);
}

#[test]
fn bad_input_is_named_in_one_line() {
    for (flag, value, takes) in [
        ("--size", "0x5", "WIDTHxHEIGHT"),
        ("--frames", "0", "from 1 to"),
        ("--time-from", "inf", "seconds"),
        ("--time-to", "late", "seconds"),
        ("--scene", "field:0", "field:N"),
        ("--isa", "mmx", "this machine has"),
    ] {
        assert_one_line(&lab(&["trade", flag, value]), 2, &[flag, value, takes]);
    }
    let backwards = ["trade", "--time-from", "5", "--time-to", "1"];
    assert_one_line(&lab(&backwards), 2, &["--time-to", "--time-from"]);
    assert_one_line(&lab(&["trade", "--out"]), 2, &["--out"]);
    assert_one_line(&lab(&["trade", "--quickly"]), 2, &["--quickly"]);
    assert_one_line(&lab(&["trade", "--quick", "now"]), 2, &["now"]);
}

#[test]
fn frames_in_which_nothing_differs_are_an_error() {
    // The show fades out to black.
    let flags = ["trade", "--ladder", "--scene", "show", "--frames", "1"];
    let end = ["--size", "48x36", "--time-from", "115.99"];
    let output = lab(&[&flags[..], &end[..]].concat());
    assert_one_line(&output, 1, &["the same", "--time-from"]);
}

#[test]
fn a_folder_that_cannot_be_written_to_is_named_before_anything_is_measured() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    fs::write(&file, "").unwrap();
    let file = file.to_str().expect("a plain name");
    for command in ["trade", "figures"] {
        assert_one_line(&lab(&[command, "--out", file]), 1, &["cannot make", file]);
    }
}
