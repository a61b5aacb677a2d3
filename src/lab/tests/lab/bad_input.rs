use super::{assert_one_line, lab};
use eightfold_tracer::Preset;

/// Arguments | message.
const LINES: &str = include_str!("bad_input.txt");

#[test]
fn bad_input_fails_in_one_line() {
    for row in LINES.trim().lines() {
        let (line, message) = row.split_once(" | ").expect("two columns");
        assert_one_line(&lab(line), 2, &[message]);
    }
    let output = lab("render --out \x1b[31mred.jpg");
    assert_one_line(&output, 2, &["invalid value 'red.jpg' for '--out <FILE>': must be"]);
    let qualities = Preset::ALL.map(Preset::name).join(", ");
    let output = lab(&format!("render --out - --quality {}", "x".repeat(99)));
    let message =
        format!("{}...' for '--quality <NAME>': must be one of {qualities}", "x".repeat(59));
    assert_one_line(&output, 2, &[&message]);
}

#[test]
fn unwritable_file_fails_at_once() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    std::fs::write(&file, "").unwrap();
    let [file, folder_name] = [&file, folder.path()].map(|path| path.to_str().expect("UTF-8"));
    for (line, name) in [
        ("truth --out FILE/truth.png", "FILE/truth.png"),
        ("render --out FOLDER", "FOLDER"),
        ("render --out FOLDER/no/x.png", "FOLDER/no/x.png"),
        ("capture --video FOLDER/no/x.mp4", "FOLDER/no/x.mp4"),
        ("render --out FOLDER/LONG", "..."),
        ("bench --frames 100000 --json FILE/x", "FILE/x"),
        ("bench --frames 100000 --json FOLDER", "FOLDER"),
        ("trade --out FILE", "FILE"),
        ("figures --out FILE/x.png", "FILE/x.png"),
        ("capture --png FILE/x --to 30", "FILE/x"),
        ("capture --video FILE/x.mp4", "FILE/x.mp4"),
        ("capture --sheet FILE/x", "FILE/x"),
    ] {
        let [line, name] = [line, name].map(|text| {
            text.replace("FILE", file)
                .replace("FOLDER", folder_name)
                .replace("LONG", &"x".repeat(300))
        });
        let output = lab(&line);
        assert_one_line(&output, 1, &[&format!("{name}: cannot ")]);
        if line.contains("/no/") {
            assert_one_line(&output, 1, &["cannot write: No such file or directory"]);
        }
    }
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}
