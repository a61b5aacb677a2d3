use super::{cells, lab, picture, printed, stderr};
use eightfold_harness::error::Difference;
use serde_json::Value;

fn bench(more: &str) -> (String, Vec<Value>) {
    let output = lab(&format!("bench --frames 3 --views 2 --json - {more}"));
    let table = stderr(&output);
    assert!(output.status.success(), "{table}");
    (table, serde_json::from_slice(&output.stdout).expect("JSON"))
}

#[track_caller]
fn number(row: &Value, key: &str) -> f64 {
    let number = row[key].as_f64();
    number.unwrap_or_else(|| panic!("no number {key} in {row}"))
}

#[test]
fn every_asked_setting_has_row() {
    let (table, rows) = bench(
        "--scene field:9 --size 96x64 --size 50x70 --threads 1 --threads 3 \
         --quality default --quality thesis --quality default",
    );
    let mut lines = cells(&table).into_iter().skip(1);
    let mut rows = rows.iter();
    for threads in [1, 3] {
        for size in ["96x64", "50x70"] {
            for quality in ["exhaustive", "default", "thesis"] {
                let row = rows.next().expect("figures");
                assert_eq!((&row["scene"], &row["quality"]), (&"field:9".into(), &quality.into()));
                if quality != "exhaustive" {
                    let line = lines.next().expect("a row");
                    assert_eq!(line[..3], [size, &threads.to_string(), quality]);
                    assert_eq!(line[3], format!("{:.3}", number(row, "ms_median")));
                    assert_eq!(line[7], format!("{:.0}", number(row, "rays")));
                }
            }
        }
    }
    assert!(lines.next().is_none() && rows.next().is_none());
}

#[test]
fn rivals_print_only_leads() {
    let (table, rows) = bench("--rivals --size 96x64 --threads 1 --quality default");
    let leads: Vec<[&str; 2]> = cells(&table).iter().map(|line| [line[1], line[6]]).collect();
    assert_eq!(leads[0], ["quality", "ahead by"]);
    assert_eq!([leads[1][0], leads[2][0]], ["default", "unguarded"]);
    assert_eq!((leads.len(), rows.len()), (3, 11));
}

#[test]
fn figures_are_consistent() {
    let (_, rows) = bench("--jagged --size 96x64 --threads 1 --threads 2");
    for row in &rows {
        let ms = number(row, "ms_median");
        assert!(ms > 0.0 && number(row, "ms_p99") >= ms);
        assert!((number(row, "fps_median") * ms - 1e3).abs() < 1e-6);
        // Every second has one frame.
        let worst = number(row, "fps_worst_second");
        assert!((worst * number(row, "ms_p99") - 1e3).abs() < 1e-6);
        let traced = number(row, "traced_fraction");
        assert!(number(row, "rays") >= traced * (96.0 * 64.0));
        let lanes = number(row, "lane_occupancy");
        assert!(lanes > 0.1 && lanes <= 1.0, "{lanes}");
        if row["quality"] == "exhaustive" {
            assert_eq!((traced, number(row, "speedup")), (1.0, 1.0));
            assert!(row["psnr_db"].is_null() && row["psnr_worst_db"].is_null());
            for none in ["pixels_over_8", "pops", "flip_mean"] {
                assert_eq!(number(row, none), 0.0, "{none}");
            }
        } else {
            assert!(traced > 0.01 && traced < 1.0);
            assert!(number(row, "psnr_worst_db") > 20.0);
            assert!(number(row, "psnr_db") >= number(row, "psnr_worst_db"));
            assert!(number(row, "flip_mean") > 0.0);
        }
        assert!(number(row, "psnr_to_64_db") > 20.0 && number(row, "flip_to_64") > 0.0);
    }
    // The work does not depend on the number of threads.
    for (one, two) in rows[..3].iter().zip(&rows[3..]) {
        for key in ["rays", "shadow_rays", "pixels_over_8", "pops", "flip_mean"] {
            assert_eq!(one[key], two[key], "{key}");
        }
    }
}

#[test]
fn errors_match_rendered_pictures() {
    let [exhaustive, default] = ["exhaustive", "default"]
        .map(|name| picture(&format!("render --size 40x30 --out - --jagged --quality {name}")).1);
    let difference = Difference::between(&exhaustive, &default);
    let line = "bench --jagged --size 40x30 --frames 1 --views 1 --quality default --json -";
    let rows: Vec<Value> = serde_json::from_str(&printed(line)).expect("JSON");
    assert!((number(&rows[1], "psnr_worst_db") - difference.psnr).abs() < 1e-6);
    assert_eq!(number(&rows[1], "pixels_over_8"), difference.over_8 as f64);
}

#[test]
fn signal_keeps_figures() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("bench.json");
    let line = "bench --frames 100000 --size 32x24 --size 48x36 --json";
    let output = super::signalled(super::command(line).arg(&file), "INT", 2);
    assert_eq!(output.status.code(), Some(130), "{}", stderr(&output));
    assert!(stderr(&output).contains("interrupted"));
    let rows: Vec<Value> = serde_json::from_slice(&std::fs::read(&file).unwrap()).unwrap();
    assert_eq!(rows.len(), 6);
    for row in &rows {
        assert!((1.0..100_000.0).contains(&number(row, "frames")), "{row}");
        assert!(row["pops"].is_null(), "{row}");
        assert!(number(row, "ms_median") > 0.0, "{row}");
    }
    let table = String::from_utf8(output.stdout).unwrap();
    assert_eq!(cells(&table).len(), 1 + 6);
}
