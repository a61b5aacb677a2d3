use super::{assert_one_line, lab};
use eightfold_tracer::Preset;

/// Arguments | message.
const LINES: &str = r#"
paint | command is 'paint'; must be one of bench, capture,
render | --out is missing
render --out "" | --out is ''; must be a .png file or -
render --output x | argument is '--output'; must be one that --help lists
render --out frame.jpg | --out is 'frame.jpg'; must be a .png file or -
render --out - --size 0x5 | --size is '0x5'; must be WIDTHxHEIGHT, 1x1 to 3840x2160
render --out - --size 3841x10 | --size is '3841x10'; must be WIDTHxHEIGHT
render --out - --time nan | --time is 'nan'; must be -1000000 to
render --out - --threads 0 | --threads is '0'; must be 1 to 256
render --out - --scene field:99999 | --scene is 'field:99999'; must be model, field:N
render --out - --scene show:end | show:NAME (eclipse, 
render --out - --isa mmx | --isa is 'mmx'; must be one of
bench --frames 1.5 | --frames is '1.5'; must be 1 to 100000
bench --json | --json has no value
truth --out - --samples 1 | --samples is '1'; must be 2 to 1048576
truth --out picture.jpg | --out is 'picture.jpg'; must be a .png file or -
view --time -1 | --time is '-1'; must be 0 to
view --quality 9 | --quality is '9'; must be one of exhaustive, finest,
capture | --png or --video or --sheet or --audio is missing
capture --png x --video y.mp4 | --png conflicts with --video
capture --png x --frames 5 | --png conflicts with --frames
capture --video show.gif | --video is 'show.gif'; must be a .mp4, .mkv or .webp file
capture --video show | --video is 'show'; must be a .mp4, .mkv or .webp file
capture --video show.webm | --video is 'show.webm'; must be a .mp4, .mkv or .webp file
capture --video /no/show.mp4 --size 333x250 | --size is 333x250; must be even in .mp4 and .mkv files
capture --sheet - --fps 1001 | --fps is '1001'; must be 1 to 1000
capture --sheet - --from 5 --to 5 | --from is 5; must be below 5
capture --sheet - --from 6960 | --from is 6960; must be below 6960
capture --sheet - --supersample 17 | --supersample is '17'; must be 1 to 16
capture --sheet - --shutter 1.5 | --shutter is '1.5'; must be 0 to 1
capture --sheet - --aperture wide | --aperture is 'wide'; must be 0 to
capture --audio - --scene model | --scene is model; with --audio, must be show or show:NAME
"#;

#[test]
fn bad_input_fails_in_one_line() {
    for row in LINES.trim().lines() {
        let (line, message) = row.split_once(" | ").expect("two columns");
        assert_one_line(&lab(line), 2, &[message]);
    }
    let output = lab("render --out \x1b[31mred.jpg");
    assert_one_line(&output, 2, &["--out is '\\u{1b}[31mred.jpg'; must be"]);
    let qualities = Preset::ALL.map(Preset::name).join(", ");
    let output = lab(&format!("render --out - --quality {}", "x".repeat(99)));
    let message = format!("--quality is '{}...'; must be one of {qualities}", "x".repeat(60));
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
