use super::{assert_one_line, lab};
use eightfold_scene_file::SceneFile;
use std::fs;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::Command;

fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/scenes")
}

fn example(name: &str) -> String {
    fs::read_to_string(examples().join(name)).expect("the example is there")
}

#[test]
fn examples_are_valid_at_any_time() {
    let mut count = 0;
    for entry in fs::read_dir(examples()).expect("a folder") {
        let path = entry.expect("a file").path();
        let text = fs::read_to_string(&path).expect("text");
        let name = path.to_str().expect("a plain name");
        let file = SceneFile::parse(name, &text).expect("a scene");
        for step in 0..=40 {
            let valid = file.at(file.length * step as f32 / 40.0).validate();
            assert_eq!(valid, Ok(()), "{}, step {step}", file.name);
        }
        count += 1;
    }
    assert!(count >= 6, "{count} examples");
}

#[test]
fn motion_passes_keys() {
    let file = SceneFile::parse("motion.ron", &example("motion.ron")).expect("a scene");
    let eye = |time| file.at(time).camera.eye.to_array();
    assert_eq!([eye(0.0), eye(3.0)], [[0.0, 3.0, 8.0], [5.0, 2.0, 6.0]]);
    assert_eq!([eye(-1.0), eye(100.0)], [eye(0.0), [0.0, 3.0, 8.0]]);
    let (before, at, after) = (eye(2.999), eye(3.0), eye(3.001));
    for i in 0..3 {
        assert!(((at[i] - before[i]) - (after[i] - at[i])).abs() < 1e-4);
    }
    let height = |time| file.at(time).spheres[0].centre.y;
    assert_eq!(height(0.5), 1.8);
    assert_eq!(height(0.25), 0.5 + 0.5 * 1.3);
    assert_eq!(height(4.25), height(0.25));
    assert_eq!(file.at(4.0).camera.up.to_array(), [0.1, 1.0, 0.0]);
    let colour = |time| file.at(time).spheres[1].material.colour.x;
    assert_eq!([colour(0.999), colour(1.0), colour(2.0)], [0.2, 0.9, 0.2]);
}

/// Example | old text | new text | text at the mistake's place | message.
const MISTAKES: &str = r#"
first | kd: 0.8, ks: 0.4 | kd: 1.8, ks: 0.4 | 1.8, ks | spheres[0].material.kd is 1.8; must be 0 to 1
first | radius: 1.2 | radius: 2e9 | 2e9 | spheres[1].radius is 2000000000; must be 1e-9 to 1e9
first | radius: 0.15 | radius: NaN | NaN | lights[0].drawn_radius is NaN; must be 0 or 1e-9 to 1e9
first | (0.0, 0.8, 0.0), f | (0.0, 2.2, 7.5), f | (0.0, 2.2, 7.5), f | camera.look_at is [0, 2.2, 7.5]; must be different from eye
first | radius: 1.2 | radios: 1.2 | radios: 1.2, m | spheres[1].radios is unknown; must be one of radius, centre, material
first | radius: 1.2 | radius: 1, radius: 2 | 1, radius: 2 | spheres[1].radius is set twice
first | radius: 1.2, | | (centre: (0.0, 1.2 | spheres[1].radius is missing
first | lights | light | light: [ | light is unknown; must be one of lights, length, camera,
first | "mirror") | "miror") | "miror") | material is "miror"; must be in materials
first | "mirror") | "LONG LONG") | "LONG | material is "LONGLONGLONGLONGLONGLONGLONGLONGLONGLONGLONGLONGLONGLONGLONG..."; must be in materials
first | radius: 1.2 | radius: LONG | LONG | is LONGLONGLONGLONGLONGLONGLONGLONGLONGLONGLONGLONGLONGLONGLONG...; must be a number
first | (0.35, 0.4, 0.5) | (0.35, 0.4) | (0.35, 0.4) | has length 2; must be a list of 3 numbers
first | 12.0, half_z | twelve, half_z | twelve | planes[0].half_x is twelve; must be a number
first | Scene( | Scene(length: 0.0, | 0.0, | length is 0; must be above 0, at most 3600
first | radius: 1.0, m | radius: 1.0 m | material: "red" | text is 'material:'; must be a comma
first | ambient | LONG | LONG | LONGLONGLONGLONGLONGLONGLONGLONGLONGLONGLONGLONGLONGLONGLONG... is unknown; must be one of camera
motion | spheres[0].centre | spheres[9].centre | (0.0, (0.0, 0.5 | path is "spheres[9].centre"; must lead to a value of the scene
motion | spheres[0].centre | spheres[0].radius | (0.0, (0.0, 0.5 | spheres[0].radius is a list; must be a number
motion | (3.0, (5.0 | (9.0, (5.0 | (6.0, (2.0 | time is 6; must be above 9
motion | (3.0, (5.0 | (inf, (5.0 | (inf, (5.0 | time is inf; must be -1e6 to 1e6
motion | (0.0, (0.0, 0.5 | (-inf, (0.0, 0.5 | (-inf, | time is -inf; must be -1e6 to 1e6
motion | (0.5, (0.0, 1.8, 0.0)) | (0.5, 1.8) | (0.5, 1.8) | value length is 1; must be 3
motion | (1.0, (0.9, 0.8, 0.2)) | (1.0, (-0.9, 0.8, 0.2)) | (1.0, (-0.9 | sets materials["lamp"].colour to [-0.9, 0.8, 0.2] at 1 s; must be 0 to 1e9
"#;

#[test]
fn mistake_has_line_and_column() {
    for row in MISTAKES.trim().lines() {
        let row: Vec<&str> = row.split('|').map(str::trim).collect();
        let [name, old, new, at, says] = row[..] else {
            panic!("{row:?}");
        };
        let text = example(&format!("{name}.ron"));
        assert!(text.contains(old), "{old}");
        let text = text.replacen(old, &new.replace("LONG", &"LONG".repeat(99)), 1);
        // A byte order mark has no column.
        let marked = format!("\u{feff}{text}");
        let error = SceneFile::parse("my.ron", &marked).expect_err(new);
        let at = text.find(&at.replace("\\n", "\n")).expect(at);
        assert!(error.chars().count() <= 200, "{error}");
        let line = text[..at].rsplit('\n').next().expect("a line");
        let (line, column) = (text[..at].matches('\n').count() + 1, line.chars().count() + 1);
        let place = format!("my.ron:{line}:{column}: ");
        assert!(error.starts_with(&place), "{error}, and not {place}");
        assert!(error.contains(says), "{error}");
    }
}

/// The radius is negative between its keys.
const MOVING: &str = r#"Scene(
    length: 4.0,
    spheres: [(centre: (0, 0, 0), radius: 1, material: (kd: 1))],
    motions: [(of: "spheres[0].radius", between: Spline, keys: [(0, 0.1), (1, 0.1), (2, 5)])],
)"#;

/// Black at times, and less at others: both together after 9.9 s.
const LATE: &str = r#"Scene(
    length: 1.0,
    motions: [
        (of: "background", between: Hold, repeat: true, keys: [(0, (1, 1, 1)), (0.9, (0, 0, 0)), (1, (0, 0, 0))]),
        (of: "sky", between: Hold, repeat: true, keys: [(0, (-1, 0, 0)), (0.1, (0, 0, 0)), (1.1, (0, 0, 0))]),
    ],
)"#;

#[test]
fn time_after_the_end_is_checked() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("late.ron").display().to_string();
    fs::write(&file, LATE).expect("it can be written");
    for command in ["render", "figures", "truth"] {
        let line = format!("{command} --size 8x8 --out - --scene {file} --time");
        assert!(lab(&format!("{line} 1.5")).status.success());
        let message = format!("{file}:5:57: motions[1] sets sky to [-1, 0, 0] at 9.95 s; must be");
        assert_one_line(&lab(&format!("{line} 9.95")), 2, &[&message]);
    }
}

#[test]
fn every_command_reports_mistake_in_one_line() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name).to_str().expect("UTF-8").to_owned();
    let [bad, moving, text, none, pipe, device] =
        ["bad.ron", "moving.ron", "text.ron", "none.ron", "pipe.ron", "device.ron"].map(file);
    fs::write(&bad, "Scene(\n    haze: -1.0,\n)\n").expect("it can be written");
    fs::write(&moving, MOVING).expect("it can be written");
    let out = folder.path().join("none").display().to_string();
    for command in [
        "bench",
        "trade",
        "figures",
        "view",
        "render --out -",
        "truth --out -",
        "capture --png OUT",
        "capture --sheet -",
    ] {
        for (name, says) in [
            (&bad, "2:11: haze is -1; must be 0 to 1000"),
            (&moving, "4:65: motions[0] sets spheres[0].radius to -0.2629"),
        ] {
            let output = lab(&format!("{} --scene {name}", command.replace("OUT", &out)));
            assert_one_line(&output, 2, &[&format!("{name}:{says}")]);
        }
    }
    assert!(!Path::new(&out).exists());
    fs::write(&text, b"Scene() // \xe9").expect("it can be written");
    let made = Command::new("mkfifo").arg(&pipe).status();
    assert!(made.expect("mkfifo runs").success());
    symlink("/dev/null", &device).expect("a link");
    // Without a writer, reading the pipe would block.
    let writer = pipe.clone();
    std::thread::spawn(move || fs::write(writer, ""));
    let output = lab(&format!("bench --scene {text}"));
    assert_one_line(&output, 2, &[&format!("{text}:1:12: byte is 0xe9; must be UTF-8")]);
    for (file, why) in
        [(&none, "No such file"), (&pipe, "not a regular file"), (&device, "not a regular file")]
    {
        let output = lab(&format!("bench --scene {file}"));
        assert_one_line(&output, 2, &[&format!("{file}: cannot read: {why}")]);
    }
}
