//! The figures of `lab bench` are consistent with each other. No test depends on measured times.

mod trouble;

use super::{cells, lab, printed, render, said};
use eightfold_lab::error::Difference;
use eightfold_lab::scenes::SceneName;
use eightfold_lab::way::Way;
use eightfold_scene_file::SceneFile;
use eightfold_stage::reader::read_png;
use eightfold_tracer::Quality;
use serde_json::Value;
use std::path::Path;

/// The titles of the columns of a part of the page on speed.
fn documented(part: &str) -> Vec<&'static str> {
    let page = include_str!("../../../../docs/speed.md");
    let (_, part) = page.split_once(part).expect("a part");
    cells(part).swap_remove(0)
}

/// Runs a short bench with small frames. Returns its table and its rows.
fn bench(more: &str) -> (String, Vec<Value>) {
    let output = lab(&format!("bench --frames 3 --views 2 --json - {more}"));
    let table = said(&output);
    assert!(output.status.success(), "{table}");
    (table, serde_json::from_slice(&output.stdout).expect("JSON"))
}

/// A number of a row.
#[track_caller]
fn number(row: &Value, key: &str) -> f64 {
    let number = row[key].as_f64();
    number.unwrap_or_else(|| panic!("no number {key} in {row}"))
}

#[test]
fn every_combination_has_its_row_with_every_figure() {
    let (table, rows) = bench(
        "--scene field:9 --size 96x64 --size 50x70 --threads 1 --threads 3 \
         --quality default --quality thesis --quality default",
    );
    let mut names = Vec::new();
    for row in &rows {
        assert_eq!(row["scene"], "field:9");
        names.push(format!(
            "{} {}x{} {}",
            row["threads"],
            row["width"],
            row["height"],
            row["quality"].as_str().expect("a name")
        ));
    }
    let mut expected = Vec::new();
    for threads in [1, 3] {
        for size in ["96x64", "50x70"] {
            for quality in ["exhaustive", "default", "thesis"] {
                expected.push(format!("{threads} {size} {quality}"));
            }
        }
    }
    assert_eq!(names, expected);

    assert!(table.contains("field:9 scene, 3 frames from 0 s to 10 s"));
    let lines = cells(&table);
    assert_eq!(lines[0], documented("lab report speed"));
    assert_eq!(lines.len(), 1 + rows.len());
    for (line, row) in lines[1..].iter().zip(&rows) {
        assert_eq!(line.len(), lines[0].len());
        assert_eq!(line[0], format!("{}x{}", row["width"], row["height"]));
        assert_eq!(line[3], row["quality"]);
        assert_eq!(line[5], format!("{:.3}", number(row, "ms_median")));
        assert_eq!(line[8], format!("{:.0}", number(row, "rays")));
    }
}

#[test]
fn the_guard_is_left_out_on_request_and_costs_points() {
    let (_, rows) = bench("--scene field:99 --size 160x120 --quality default --unguarded");
    let traced = |name: &str| {
        let row = rows.iter().find(|row| row["quality"] == name);
        number(row.expect(name), "traced_fraction")
    };
    assert!(traced("unguarded") < traced("default"));
}

#[test]
fn shadows_are_hard_on_request() {
    let rows = |scene| {
        bench(&format!(
            "--scene {scene} --size 96x64 --quality default --hard-shadows"
        ))
        .1
    };
    let sun = rows("show:colonnade");
    let names: Vec<&Value> = sun.iter().map(|row| &row["quality"]).collect();
    assert_eq!(
        names,
        ["exhaustive", "exhaustive, hard", "default", "default, hard"]
    );
    assert!(
        number(&sun[1], "psnr_worst_db") < 60.0,
        "the sun has a size"
    );
    let points = rows("model");
    assert!(points[1]["psnr_worst_db"].is_null(), "its lamps have none");
}

#[test]
fn figures_fit_each_other() {
    let (_, rows) = bench("--jagged --size 96x64 --threads 1 --threads 2");
    for (row, exhaustive) in rows.iter().zip([0, 0, 0, 3, 3, 3].map(|i| &rows[i])) {
        let ms = number(row, "ms_median");
        assert!(ms > 0.0 && number(row, "ms_p99") >= ms);
        assert!((number(row, "fps_median") * ms - 1e3).abs() < 1e-6);
        // Each of three frames in ten seconds is in its own second.
        let worst = number(row, "fps_worst_second");
        assert!((worst * number(row, "ms_p99") - 1e3).abs() < 1e-6);
        let speedup = number(exhaustive, "ms_median") / ms;
        assert!((number(row, "speedup_vs_exhaustive") - speedup).abs() < 1e-6 * speedup);
        assert!(number(row, "floor_ratio") > 0.0);
        let traced = number(row, "traced_fraction");
        assert!(number(row, "rays") >= traced * (96.0 * 64.0));
        let lanes = number(row, "lane_occupancy");
        assert!(lanes > 0.1 && lanes <= 1.0, "{lanes}");
        if row["quality"] == "exhaustive" {
            assert_eq!(traced, 1.0);
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
        for key in [
            "rays",
            "shadow_rays",
            "traced_fraction",
            "pixels_over_8",
            "pops",
            "flip_mean",
        ] {
            assert_eq!(one[key], two[key], "{key}");
        }
    }
}

#[test]
fn the_show_has_a_row_for_each_scene_and_quality_and_a_line_for_its_worst_second() {
    let (table, rows) = bench("--scene show --size 32x18 --quality default");
    assert!(table.contains("show, each scene in 3 frames from 0 s to 115.98"));
    let scenes = "title model method colonnade machine flake mirrors swarm finale".split(' ');
    let names = scenes.flat_map(|scene| {
        let name = |quality| (format!("show:{scene}"), quality);
        ["exhaustive", "default"].map(name)
    });
    let found = rows.iter().map(|row| {
        let text = |key: &str| row[key].as_str().expect("text");
        (text("scene").to_owned(), text("quality"))
    });
    assert!(found.eq(names));
    let lines = cells(&table);
    assert_eq!(lines[0], documented("lab report show"));
    assert_eq!(lines.len(), 1 + rows.len());
    for (line, row) in lines[1..].iter().zip(&rows) {
        let worst = number(row, "fps_worst_second");
        // Each of three frames is in its own second.
        assert!((worst * number(row, "ms_p99") - 1e3).abs() < 1e-6);
        assert_eq!(line[2], row["scene"]);
        assert_eq!(line[5], format!("{worst:.1}"));
    }
    let worst = rows.iter().filter(|row| row["quality"] == "default");
    let fps = |row: &Value| number(row, "fps_worst_second");
    let worst = worst.min_by(|a, b| fps(a).total_cmp(&fps(b)));
    let worst = worst.expect("a row");
    let (fps, scene) = (number(worst, "fps_worst_second"), &worst["scene"]);
    let last = table.lines().last().expect("a line");
    assert!(last.starts_with("Worst second of the show at 32x18, threads "));
    assert!(
        last.contains(&format!("default {fps:.1} fps from ")),
        "{last}"
    );
    let scene = scene.as_str().expect("a name");
    assert!(last.ends_with(&format!("({scene})")), "{last}");
}

#[test]
fn a_scene_of_the_show_is_its_part_of_the_show() {
    let rows = |more| bench(&format!("--size 32x18 --quality default {more}")).1;
    // The machine plays from 56 s to 68 s.
    let part = rows("--scene show:machine --time-from 1 --time-to 3");
    let show = rows("--scene show --time-from 57 --time-to 59");
    assert_eq!((part.len(), show.len()), (2, 2));
    for (a, b) in part.iter().zip(&show) {
        for key in ["scene", "rays", "psnr_worst_db", "pops", "flip_mean"] {
            assert_eq!(a[key], b[key], "{key}");
        }
    }
}

#[test]
fn marks_of_the_method_are_no_errors() {
    let rows = bench("--scene show:method --size 320x180 --quality default").1;
    let psnr = number(&rows[1], "psnr_worst_db");
    assert!(psnr > 32.0, "{psnr}");
}

#[test]
fn errors_are_those_of_the_pictures_that_render_draws() {
    let picture = |quality| {
        let more = format!("--jagged --time 2.5 --quality {quality}");
        read_png(&render(Path::new("-"), &more).stdout).1
    };
    let difference = Difference::between(&picture("exhaustive"), &picture("default"));
    let (_, rows) = bench("--jagged --size 40x30 --time-from 2.5 --time-to 2.5 --quality default");
    assert!((number(&rows[1], "psnr_worst_db") - difference.psnr).abs() < 1e-6);
    assert!((number(&rows[1], "psnr_db") - difference.psnr).abs() < 1e-6);
    assert_eq!(number(&rows[1], "pixels_over_8"), difference.over_8 as f64);
}

#[test]
fn times_reach_from_the_first_to_the_last() {
    let rays = |more: &str| {
        let text = printed(&format!(
            "bench --size 40x30 --quality exhaustive --json - {more}"
        ));
        let rows: Vec<Value> = serde_json::from_str(&text).expect("JSON");
        number(&rows[0], "rays")
    };
    let at = |time| rays(&format!("--frames 1 --time-from {time}"));
    let all = rays("--frames 3 --time-from -1 --time-to 4");
    assert!((at("-1") + at("1.5") + at("4") - 3.0 * all).abs() < 1e-6);
}

#[test]
fn a_file_gets_the_json_and_standard_output_the_table() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("bench.json");
    let table = printed(&format!(
        "bench --size 40x30 --frames 2 --threads 2 --json {}",
        file.display()
    ));
    let rows: Vec<Value> = serde_json::from_slice(&std::fs::read(&file).unwrap()).expect("JSON");
    assert_eq!(cells(&table).len(), 1 + rows.len());
    let qualities = rows
        .iter()
        .map(|row| row["quality"].as_str().expect("a name"));
    assert!(qualities.eq(["exhaustive", "thesis", "default"]));
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn a_frame_of_a_scene_file_is_timed_without_reading_what_the_file_says() {
    let way = Way::new("thesis", Quality::THESIS);
    let file = SceneFile::parse("room.ron", "Scene()").expect("a scene");
    let file = SceneName::File(Box::leak(Box::new(file)));
    assert!(way.made_before(file, 0.0).is_some());
    assert!(way.made_before(SceneName::Model, 0.0).is_none());
}
