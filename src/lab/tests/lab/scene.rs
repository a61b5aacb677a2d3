//! Scene files say what is in them, and where something is wrong; scenes that are written and read again are the same.

#[rustfmt::skip]
mod every_field;
mod fields;

use super::{assert_one_line, lab, printed, render};
use eightfold_lab::scenes::SceneName;
use eightfold_scene_file::SceneFile;
use eightfold_stage::reader::read_png;
use eightfold_tracer::scene::Scene;
use std::fs;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The folder of the examples.
fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/scenes")
}

/// An example's text.
fn example(name: &str) -> String {
    fs::read_to_string(examples().join(name)).expect("the example is there")
}

/// The contents of a scene, to the bit.
fn contents(scene: &Scene) -> String {
    format!("{scene:?}")
}

#[test]
fn every_example_is_a_scene_at_any_time() {
    let mut count = 0;
    for entry in fs::read_dir(examples()).expect("a folder") {
        let path = entry.expect("a file").path();
        let file = SceneFile::read(path.to_str().expect("a plain name")).expect("a scene");
        for step in 0..=40 {
            let time = file.length * step as f32 / 40.0;
            assert_eq!(
                file.at(time).validate(),
                Ok(()),
                "{} at {time} s",
                file.name
            );
        }
        count += 1;
    }
    assert!(count >= 6, "{count} examples");
}

#[test]
fn a_scene_that_is_exported_is_the_same_at_its_frames() {
    let names = "model field:40 show:title show:method show:machine show:finale".split(' ');
    for name in names {
        let name: SceneName = name.parse().expect("a scene");
        let fps = "10".parse().expect("a rate");
        let text = eightfold_lab::scene::record(name, fps).expect("it can be told");
        let file = SceneFile::parse("exported.ron", &text).expect("a scene");
        assert_eq!(file.length, name.length());
        for frame in 0..fps.frames(name.length()) {
            let time = fps.time(frame);
            let (mut read, mut compiled) = (file.at(time), name.at(time));
            // Captions that are not to be seen are told, too.
            for scene in [&mut read, &mut compiled] {
                let all = scene.captions;
                scene.captions.clear();
                for caption in all.iter().filter(|caption| caption.brightness > 0.0) {
                    scene.captions.push(*caption);
                }
            }
            assert_eq!(contents(&read), contents(&compiled), "{name} at {time} s");
        }
    }
}

#[test]
fn an_exported_scene_gives_the_same_picture() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("machine.ron");
    let file = file.to_str().expect("a plain name");
    printed(&format!("scene --export show:machine --fps 2 --out {file}"));
    let picture = |scene| {
        let output = render(Path::new("-"), &format!("--scene {scene} --time 3.5"));
        assert!(output.status.success());
        read_png(&output.stdout)
    };
    assert!(picture(file) == picture("show:machine"));
}

#[test]
fn motions_pass_their_keys() {
    let file = SceneFile::parse("motion.ron", &example("motion.ron")).expect("a scene");
    let eye = |time| file.at(time).camera.eye.to_array();
    assert_eq!(eye(0.0), [0.0, 3.0, 8.0]);
    assert_eq!(eye(3.0), [5.0, 2.0, 6.0]);
    // Before the first key and after the last one it keeps still.
    assert_eq!(eye(-1.0), eye(0.0));
    assert_eq!(eye(100.0), [0.0, 3.0, 8.0]);
    // A spline has no corners: the speed before a key is that after it.
    let (before, at, after) = (eye(2.999), eye(3.0), eye(3.001));
    for i in 0..3 {
        assert!(((at[i] - before[i]) - (after[i] - at[i])).abs() < 1e-4);
    }
    let height = |time| file.at(time).spheres[0].centre.y;
    assert_eq!(height(0.5), 1.8);
    assert_eq!(height(0.25), 0.5 + 0.5 * 1.3);
    assert_eq!(height(4.25), height(0.25));
    let colour = |time| file.at(time).spheres[1].material.colour.x;
    assert_eq!([colour(0.999), colour(1.0), colour(2.0)], [0.2, 0.9, 0.2]);
}

/// The Rust text that the lab makes of a scene file, which is compiled as a module of these tests: `UPDATE_GOLDEN=1` writes it.
#[track_caller]
fn assert_is_compiled(name: &str, file: &Path) {
    let text = printed(&format!("scene --rust {}", file.display()));
    let made = format!("Made of {}", file.display());
    let text = text.replace(&made, &format!("Made of {name}.ron"));
    // The functions that interpolate are those of the lab.
    let (scene, keys) = text.split_once("mod keys {").expect("functions");
    assert!(keys.contains("pub fn spline<"), "{keys}");
    let text = format!("{scene}#[path = \"../../../../scene_file/keys.rs\"]\nmod keys;\n");
    let known = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/lab/scene/{name}.rs"));
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        fs::write(&known, &text).expect("it can be written");
    }
    let known = fs::read_to_string(known).expect("it is there");
    assert!(
        text == known,
        "tests/lab/scene/{name}.rs has to be made anew"
    );
}

#[test]
fn what_is_wrong_is_named_by_line_column_field_and_what_it_takes() {
    let first = example("first.ron");
    let told = |old: &str, new: &str| {
        assert!(first.contains(old), "{old}");
        let spoilt = first.replacen(old, new, 1);
        let at = spoilt.find(new).expect("it is there");
        let error = SceneFile::parse("my.ron", &spoilt).expect_err("it is wrong");
        let line = spoilt[..at].matches('\n').count() + 1;
        assert!(error.starts_with(&format!("my.ron:{line}:")), "{error}");
        assert!(!error.contains('\n'), "{error}");
        error
    };
    for (old, new, says) in [
        (
            "kd: 0.8, ks: 0.4",
            "kd: 1.8, ks: 0.4",
            "materials[\"red\"].kd is 1.8, and takes 0 to 1",
        ),
        (
            "radius: 1.2",
            "radius: -1.2",
            "spheres[1].radius is -1.2, and takes a length from 1e-9",
        ),
        ("radius: 1.2", "radios: 1.2", "`radios`"),
        (
            "material: \"mirror\"",
            "material: \"miror\"",
            "takes one of materials: \"floor\", \"glass\"",
        ),
        (
            "look_at: (0.0, 0.8, 0.0)",
            "look_at: (0.0, 2.2, 7.5)",
            "a point that is not the eye",
        ),
        ("radius: 0.15", "radius: NaN", "takes a finite one"),
        ("colour: (0.35, 0.4, 0.5)", "colour: (0.35, 0.4)", "3"),
        ("half_x: 12.0", "half_x: twelve", ""),
    ] {
        let error = told(old, new);
        assert!(error.contains(says), "{error}");
    }
    // To the column.
    let error = told("radius: 1.2", "radius: 2e9");
    let line = first
        .lines()
        .find(|line| line.contains("radius: 1.2"))
        .expect("a line");
    let column = line.find("1.2, material").expect("a number") + 1;
    assert!(
        error.contains(&format!(":{column}: spheres[1].radius is 2000000000")),
        "{error}"
    );
}

#[test]
fn a_byte_order_mark_is_no_part_of_the_text() {
    let first = example("first.ron");
    let [plain, marked] = [first.clone(), format!("\u{feff}{first}")]
        .map(|text| SceneFile::parse("first.ron", &text).expect("a scene"));
    assert_eq!(plain, marked);
    let error = SceneFile::parse("my.ron", "\u{feff}Scene(haze: -1.0)").expect_err("it is wrong");
    assert!(error.starts_with("my.ron:1:13: haze is -1"), "{error}");
}

#[test]
fn what_may_have_no_end_is_not_read() {
    let folder = tempfile::tempdir().expect("a folder");
    let [pipe, device] = ["pipe.ron", "device.ron"].map(|name| folder.path().join(name));
    let made = Command::new("mkfifo").arg(&pipe).status();
    assert!(made.expect("mkfifo runs").success());
    symlink("/dev/null", &device).expect("a link");
    // One that reads the pipe is not kept waiting: it gets an empty text.
    let writer = pipe.clone();
    std::thread::spawn(move || fs::write(writer, ""));
    for file in [&pipe, &device] {
        let name = file.to_str().expect("UTF-8");
        let output = lab(&format!("bench --scene {name}"));
        assert_one_line(&output, 2, &["cannot read", name, "not a regular file"]);
    }
}

#[test]
fn what_is_wrong_with_a_motion_is_named() {
    let text = example("motion.ron");
    for (old, new, says) in [
        (
            "spheres[0].centre",
            "spheres[9].centre",
            "takes the path of a number or a vector",
        ),
        (
            "spheres[0].centre",
            "spheres[0].material",
            "takes the path of a number or a vector",
        ),
        (
            "(3.0, (5.0",
            "(9.0, (5.0",
            "a time that is not after the last one's",
        ),
        (
            "(0.5, (0.0, 1.8, 0.0))",
            "(0.5, 1.8)",
            "takes as many numbers as spheres[0].centre has",
        ),
        (
            "(1.0, (0.9, 0.8, 0.2))",
            "(1.0, (-0.9, 0.8, 0.2))",
            "is wrong at 1 s: materials[\"lamp\"].colour",
        ),
    ] {
        assert!(text.contains(old), "{old}");
        let error = SceneFile::parse("my.ron", &text.replacen(old, new, 1)).expect_err(new);
        assert!(error.contains(says), "{error}");
    }
}

#[test]
fn fields_that_are_missing_twice_or_unknown_are_told() {
    for (fields, says) in [
        (
            "radius: 1, material: \"a\"",
            "`Sphere` takes a field `centre`",
        ),
        (
            "centre: (0, 0, 0), radius: 1, radius: 2, material: \"a\"",
            "`radius` is twice in `Sphere`",
        ),
        (
            "centre: (0, 0, 0), size: 1, material: \"a\"",
            "`Sphere` has no field `size`, and takes `centre`, `radius`, `material`",
        ),
    ] {
        let text = format!("(materials: {{\"a\": ()}}, spheres: [({fields})])");
        let error = SceneFile::parse("my.ron", &text).expect_err("it is wrong");
        assert!(
            error.starts_with("my.ron:1:") && error.contains(says),
            "{error}"
        );
    }
    let error = SceneFile::parse("my.ron", "(motion: [])").expect_err("it is wrong");
    assert!(
        error.contains("`captions`, `copper_bars`, `motions`"),
        "{error}"
    );
}

#[test]
fn two_motions_of_one_number_are_no_rust() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("twice.ron");
    let keys = "keys: [(0.0, (0.0, 0.0, 9.0)), (1.0, (1.0, 0.0, 9.0))]";
    let part = "(of: \"camera.eye[1]\", keys: [(0.0, 1.0)])";
    let text = format!("(motions: [(of: \"camera.eye\", {keys}), {part}])");
    fs::write(&file, text).expect("it can be written");
    let output = lab(&format!("scene --rust {}", file.display()));
    assert_one_line(&output, 1, &["camera.eye and camera.eye[1] move the same"]);
}

#[test]
fn too_many_objects_are_told() {
    let sphere = "(centre: (0.0, 0.0, 0.0), radius: 1.0, material: \"m\"),";
    let text = format!(
        "Scene(materials: {{\"m\": ()}}, spheres: [{}])",
        sphere.repeat(321)
    );
    let error = SceneFile::parse("many.ron", &text).expect_err("too many");
    assert!(
        error.contains("spheres has 321, and takes up to 320"),
        "{error}"
    );
}

#[test]
fn bad_input_is_named_in_one_line() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("bad.ron");
    let name = file.to_str().expect("a plain name");
    fs::write(&file, "Scene(\n    haze: -1.0,\n)\n").expect("it can be written");
    for command in ["bench", "trade", "figures", "view"] {
        let output = lab(&format!("{command} --scene {name}"));
        assert_one_line(
            &output,
            2,
            &["bad.ron:2:11: haze is -1, and takes 0 to 1000"],
        );
    }
    let bench = |name: &str| lab(&format!("bench --scene {name}"));
    let none = folder.path().join("none.ron");
    let none = none.to_str().expect("a plain name");
    assert_one_line(&bench(none), 2, &["cannot read", none]);
    fs::write(&file, b"Scene() // \xe9").expect("it can be written");
    assert_one_line(&bench(name), 2, &[name, "not UTF-8"]);
}
