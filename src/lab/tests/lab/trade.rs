//! `lab trade` writes all its files, and its figures are consistent. No test depends on measured times.

use super::{assert_one_line, cells, command, lab, printed};
use anyhow::Result;
use eightfold_lab::trade::check;
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Stdio;
use std::sync::LazyLock;
use tempfile::TempDir;

const PLOTS: [&str; 4] = ["front", "squares", "resolution", "objects"];

/// The frames of the one `lab trade` that most tests look at.
const FRAMES: &str = "--size 160x120 --frames 2 --views 2 --time-from 1 --time-to 5";

/// Its output, and its folder.
static TRADE: LazyLock<(String, TempDir)> = LazyLock::new(|| {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().display();
    (
        printed(&format!("trade --quick --out {out} {FRAMES}")),
        folder,
    )
});

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
#[ignore = "many frames"]
fn all_that_is_measured_is_written_whole() {
    let (table, folder) = &*TRADE;
    assert_eq!(cells(table)[0][..2], ["quality", "speed-up"]);
    assert!(table.contains("160x120"), "{table}");
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
        for key in ["speedup", "flip_mean", "pops", "pixels_over_8"] {
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
    assert_eq!(json["views"].as_array().map(Vec::len), Some(2));
}

#[test]
fn no_point_of_the_front_is_beaten_by_another() {
    let json = json(TRADE.1.path());
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

#[cfg(unix)]
#[test]
fn what_is_done_before_a_signal_is_written_whole() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("trade");
    // So many frames would take far too long.
    let lab = command("trade --quick --size 48x36 --frames 100000 --out")
        .arg(&out)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // By then the command heeds signals.
    while !out.exists() {
        std::thread::yield_now();
    }
    assert!(crate::signal(&lab.id().to_string(), "INT"));
    let mut output = lab.wait_with_output().unwrap();
    let table = String::from_utf8(std::mem::take(&mut output.stdout)).expect("text");
    assert_one_line(
        &output,
        130,
        &["stopped early", out.to_str().expect("a plain name")],
    );
    assert!(table.contains("stopped early"));
    assert_whole(&out, &["front", "squares"]);
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
    let rows = cells(&table).split_off(1);
    let is_so = |row: &Vec<&str>| row[1].ends_with(", antialiased");
    assert!(rows.len() == 9 && rows.iter().all(is_so), "{table}");
    // The exhaustive frames, which serve as reference, are antialiased, too.
    let exhaustive = &rows[0];
    assert_eq!(exhaustive[..2], ["exhaustive", "square 1, antialiased"]);
    assert_eq!(exhaustive[4..8], ["-", "-", "0.0", "0.0"]);
    assert_ne!(exhaustive[3], "100.0 %", "more than a point a pixel");
}

#[test]
fn frames_in_which_nothing_differs_are_an_error() {
    // The show fades out to black.
    let output = lab("trade --ladder --scene show --frames 1 --size 48x36 --time-from 115.99");
    assert_one_line(&output, 1, &["the same", "--time-from"]);
}

#[test]
fn a_table_without_a_row_is_an_error() {
    let exhaustive = (true, true);
    let with = |other, all| check([exhaustive, other].into_iter(), all);
    let said = |result: Result<()>| result.expect_err("no row").to_string();
    let exact = said(with((true, false), true));
    assert!(exact.starts_with("every setting draws the same"), "{exact}");
    let off = said(with((false, false), false));
    assert!(off.starts_with("no setting differs"), "{off}");
    assert!(with((false, false), true).is_ok() && with((false, true), false).is_ok());
}
