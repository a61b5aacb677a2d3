use super::{assert_one_line, lab};
use eightfold_tracer::Quality;

const LINES: [(&str, &str); 34] = [
    ("paint", "paint"),
    ("render", "--out"),
    ("render --out \"\"", "--out"),
    ("render --output x", "--output"),
    ("render --out frame.jpg", "--out frame.jpg .png"),
    ("render --out - --size 0x5", "--size 0x5 WIDTHxHEIGHT"),
    ("render --out - --size 640", "--size 640 WIDTHxHEIGHT"),
    ("render --out - --size 3841x10", "--size 3841x10 3840x2160"),
    ("render --out - --time now", "--time now must be"),
    ("render --out - --time nan", "--time nan must be"),
    ("render --out - --threads 0", "--threads 0 must be 1 to 256"),
    ("render --out - --scene field:0", "--scene field:0 field:N"),
    ("render --out - --scene field:99999", "--scene field:N"),
    ("render --out - --scene show:end", "--scene show:finale"),
    (
        "render --out - --isa mmx",
        "--isa mmx must be on this machine",
    ),
    ("bench --frames 1.5", "--frames 1.5 must be 1 to 100000"),
    ("bench --json", "--json"),
    ("missed --seeds 0", "--seeds must be 1 to"),
    ("truth --scene model", "--out"),
    (
        "truth --out - --samples 1",
        "--samples must be 2 to 1048576",
    ),
    ("truth --out picture.jpg", "--out .png"),
    ("view --time -1", "--time must be 0 to"),
    ("view --quality 9", "--quality exhaustive"),
    ("capture", "--png --video --sheet --audio"),
    ("capture --png x --video y.mp4", "--png --video"),
    ("capture --png x --frames 5", "--frames --png"),
    (
        "capture --sheet - --fps 1001",
        "--fps 1001 must be 1 to 1000",
    ),
    ("capture --sheet - --from x", "--from must be 0 to"),
    ("capture --sheet - --from 5 --to 5", "--from 5 --to 5 empty"),
    ("capture --sheet - --from 6960", "--from 6960 to 6960"),
    (
        "capture --sheet - --supersample 17",
        "--supersample 1 to 16",
    ),
    ("capture --sheet - --shutter 1.5", "--shutter 0 to 1"),
    ("capture --sheet - --aperture wide", "--aperture 0 to"),
    ("capture --audio - --scene model", "--audio model no sound"),
];

#[test]
fn bad_input_fails_in_one_line() {
    for (line, words) in LINES {
        assert_one_line(&lab(line), 2, &words.split(' ').collect::<Vec<_>>());
    }
    let qualities = format!("exhaustive, thesis, {}", Quality::NAMES.join(", "));
    let output = lab("render --out - --quality best");
    assert_one_line(&output, 2, &["--quality", &qualities]);
}

#[test]
fn unwritable_file_fails_at_once() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    std::fs::write(&file, "").unwrap();
    let [file, folder_name] = [&file, folder.path()].map(|path| path.to_str().expect("UTF-8"));
    for (line, words) in [
        ("truth --out FILE/truth.png", "cannot write FILE/truth.png"),
        ("render --out FOLDER", "cannot write FOLDER"),
        (
            "render --out FOLDER/no/x.png",
            "cannot write FOLDER/no/x.png",
        ),
        ("render --out FOLDER/LONG", "cannot write"),
        ("bench --frames 100000 --json FILE/x", "cannot write FILE/x"),
        ("bench --frames 100000 --json FOLDER", "cannot write FOLDER"),
        ("trade --out FILE", "cannot make FILE"),
        ("figures --out FILE/x.png", "cannot write FILE/x.png"),
        ("capture --png FILE/x --to 30", "cannot make FILE/x"),
        ("capture --video FILE/x.mp4", "cannot write FILE/x.mp4"),
        ("capture --sheet FILE/x", "cannot write FILE/x"),
    ] {
        let [line, words] = [line, words].map(|text| {
            text.replace("FILE", file)
                .replace("FOLDER", folder_name)
                .replace("LONG", &"x".repeat(300))
        });
        assert_one_line(&lab(&line), 1, &words.split(' ').collect::<Vec<_>>());
    }
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}
