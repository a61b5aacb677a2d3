use super::{assert_one_line, lab};
use eightfold_scene_file::SceneFile;
use std::fs;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::Command;

#[test]
fn examples_are_valid_at_any_time() {
    let mut count = 0;
    for entry in fs::read_dir("../../examples/scenes").expect("a folder") {
        let path = entry.expect("a file").path();
        let text = fs::read_to_string(&path).expect("text");
        let name = path.to_str().expect("a plain name");
        SceneFile::parse(name, &text).expect("a scene at all times");
        count += 1;
    }
    assert!(count >= 6, "{count} examples");
}

/// The radius is negative between its keys.
const MOVING: &str = r#"Scene(
    length: 4.0,
    spheres: [(centre: (0, 0, 0), radius: 1, material: (kd: 1))],
    motions: [(of: "spheres[0].radius", between: Spline, keys: [(0, 0.1), (1, 0.1), (2, 5)])],
)"#;

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
