use super::{cells, printed, stderr};
use eightfold_tracer::Preset;
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::sync::LazyLock;
use tempfile::TempDir;

static TRADE: LazyLock<(String, TempDir)> = LazyLock::new(|| {
    let folder = tempfile::tempdir().expect("a folder");
    let line = "trade --size 64x48 --frames 2 --views 1 --out";
    (printed(&format!("{line} {}", folder.path().display())), folder)
});

fn rows(folder: &Path) -> Vec<Value> {
    let json = fs::read(folder.join("trade.json")).unwrap();
    let json: Value = serde_json::from_slice(&json).expect("JSON");
    json["rows"].as_array().expect("rows").clone()
}

#[track_caller]
fn assert_plots(folder: &Path, plots: &str) {
    let mut expected = BTreeSet::from(["trade.json".to_owned()]);
    for plot in plots.split(' ') {
        let svg = fs::read_to_string(folder.join(format!("{plot}.svg"))).unwrap();
        assert!(svg.starts_with("<svg"), "{plot}");
        assert!(svg.trim_end().ends_with("</svg>"), "{plot}");
        assert!(svg.contains("<circle") && svg.contains("<text"), "{plot}");
        expected.insert(format!("{plot}.svg"));
    }
    let files = fs::read_dir(folder).unwrap().map(|file| file.unwrap().file_name());
    let files = files.map(|name| name.into_string().expect("a plain name"));
    assert_eq!(files.collect::<BTreeSet<_>>(), expected);
}

#[test]
fn varied_fields_are_measured_and_plotted() {
    let (table, folder) = &*TRADE;
    assert_eq!(cells(table)[0][..2], ["quality", "speed-up"]);
    assert_plots(folder.path(), "front squares resolution objects");
    let rows = rows(folder.path());
    assert_eq!(rows[0]["quality"], "exhaustive");
    assert!(rows[0]["psnr_db"].is_null());
    let names = "fastest; default, square 32; default, tolerance 64; default, depth 0; \
                 default, contribution 0.1; default, unguarded; thesis, keys 1/1; resolution:0.5; checkerboard; \
                 thesis, highlight 0.25; thesis, differing 9; tolerance 9, depth 3, contribution 0.05";
    for name in names.split("; ") {
        assert!(rows.iter().any(|row| row["quality"] == name), "{name}");
    }
    for row in rows {
        for key in "speedup flip_mean pops flip_to_64".split(' ') {
            let number = row[key].as_f64();
            assert!(number.is_some_and(|n| n >= 0.0), "{key} of {row}");
        }
    }
}

#[test]
fn front_is_unbeaten() {
    let rows = rows(TRADE.1.path());
    let costs = |row: &Value| {
        let cost = |key: &str| row[key].as_f64().expect("a number");
        [-cost("speedup"), cost("flip_mean"), cost("pops")]
    };
    let beats = |a: &Value, b: &Value| {
        let (a, b) = (costs(a), costs(b));
        a != b && (0..3).all(|i| a[i] <= b[i])
    };
    let (front, others): (Vec<&Value>, Vec<&Value>) =
        rows.iter().partition(|row| row["on_front"] == true);
    let is_beaten = |row: &Value| front.iter().any(|other| beats(other, row));
    // Times decide which other rows are on the front.
    assert!(front.iter().any(|row| costs(row)[1..] == [0.0; 2]));
    assert!(!front.iter().any(|row| is_beaten(row)));
    for row in others {
        let name = row["quality"].as_str().expect("a name");
        let excluded = ["unguarded", "differing", "resolution", "checkerboard"];
        let is_excluded = excluded.iter().any(|excluded| name.contains(excluded));
        assert!(is_beaten(row) || is_excluded, "{row}");
    }
}

#[test]
fn signal_keeps_results() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("trade");
    let line = "trade --size 48x36 --frames 100000 --out";
    let output = super::signalled(super::command(line).arg(&out), "INT", 2);
    assert_eq!(output.status.code(), Some(130), "{}", stderr(&output));
    assert!(stderr(&output).contains("interrupted"));
    assert_plots(&out, "front squares");
    for row in rows(&out) {
        let frames = row["frames"].as_u64().expect("a number");
        assert!((1..100_000).contains(&frames));
        assert!(row["flip_mean"].is_null() && row["pops"].is_null());
    }
}

#[test]
fn ladder_has_named_qualities() {
    let table = printed("trade --ladder --size 48x36 --frames 2 --views 1");
    let names: Vec<&str> = cells(&table).iter().skip(1).map(|row| row[0]).collect();
    assert_eq!(names, Preset::ALL.map(Preset::name));
}
