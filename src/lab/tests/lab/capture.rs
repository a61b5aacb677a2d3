//! `lab capture` writes complete files whose bytes depend on its arguments alone.

use super::{assert_one_line, command, interrupted, lab, limited, printed, said, signal};
use eightfold::show;
use eightfold::sound::RATE;
use eightfold_lab::error::{Difference, worst_channel};
use eightfold_lab::wav;
use eightfold_stage::{needs, reader::read_png, run, tool};
use std::fs;
use std::io::Read;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::{Command, Stdio};

/// Returns a command line with small frames of the model scene, unless it names others.
fn line(arguments: &str) -> String {
    let defaults = [("--size", "48x32"), ("--scene", "model")];
    let missing = defaults
        .iter()
        .filter(|(flag, _)| !arguments.contains(flag));
    let missing: String = missing
        .map(|(flag, word)| format!(" {flag} {word}"))
        .collect();
    format!("capture {arguments}{missing}")
}

/// Captures into a file or a folder.
#[track_caller]
fn captured(flag: &str, target: &Path, more: &str) {
    printed(&line(&format!("{flag} {} {more}", target.display())));
}

/// Returns the names and contents of the files in a folder, sorted by name.
fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let entries = fs::read_dir(folder).expect("a folder");
    let mut files: Vec<(String, Vec<u8>)> = entries
        .map(|entry| entry.expect("an entry"))
        .map(|entry| {
            let name = entry.file_name().into_string().expect("a plain name");
            (name, fs::read(entry.path()).expect("a file"))
        })
        .collect();
    files.sort();
    files
}

/// Draws frames by `lab render`.
fn rendered(times: &[f64], size: &str) -> Vec<u32> {
    let picture = |time: &f64| {
        let output = lab(&format!("render --size {size} --time {time} --out -"));
        read_png(&output.stdout).1
    };
    times.iter().flat_map(picture).collect()
}

#[test]
fn frames_are_pictures_of_their_times() {
    let folder = tempfile::tempdir().unwrap();
    captured("--png", folder.path(), "--fps 4 --from 10 --to 12");
    let files = files(folder.path());
    assert_eq!(files[0].0, "frame-000010.png");
    let frames: Vec<u32> = files
        .iter()
        .flat_map(|(_, bytes)| read_png(bytes).1)
        .collect();
    assert!(frames == rendered(&[2.5, 2.75], "48x32"));
}

#[test]
fn default_range_is_the_scene() {
    for (scene, seconds) in [("show", show::LENGTH), ("model", show::MODEL_LENGTH.ceil())] {
        for end in ["", "--to 99999"] {
            let folder = tempfile::tempdir().unwrap();
            let more = format!("--scene {scene} --fps 1 --size 8x8 {end}");
            captured("--png", folder.path(), &more);
            assert_eq!(files(folder.path()).len(), seconds as usize);
        }
    }
}

/// Runs the page's own line for GNU parallel, with smaller frames.
#[test]
fn parallel_draws_the_same_files() {
    needs!(&["parallel"]);
    let page = include_str!("../../../../docs/lab.md");
    let recipe = page.lines().find(|line| line.trim().starts_with("seq "));
    let program = env!("CARGO_BIN_EXE_lab");
    let small = line("--fps 1");
    let recipe = recipe
        .expect("a line for parallel")
        .replace("100", "10")
        .replace("6900", "20")
        .replace("target/release/lab capture", &format!("{program} {small}"));
    let folder = tempfile::tempdir().unwrap();
    let mut shell = Command::new("sh");
    shell
        .args(["-c", &recipe])
        .current_dir(&folder)
        .stdin(Stdio::null());
    // There parallel keeps its files, and by SHELL it chooses how it quotes.
    shell.env("HOME", folder.path()).env("SHELL", "/bin/sh");
    let output = shell.output().unwrap();
    assert!(output.status.success(), "{recipe}: {}", said(&output));
    let whole = folder.path().join("whole");
    captured("--png", &whole, "--fps 1");
    assert!(files(&folder.path().join("frames")) == files(&whole));
}

#[test]
fn supersampled_pixel_is_the_mean_of_its_parts() {
    let folder = tempfile::tempdir().unwrap();
    let more = "--to 1 --quality exhaustive --supersample 2";
    captured("--png", folder.path(), more);
    let (_, mean) = read_png(&files(folder.path())[0].1);
    let twice = lab("render --size 96x64 --out - --quality exhaustive");
    let (width, twice) = read_png(&twice.stdout);
    let far = (0..mean.len()).filter(|i| {
        let (x, y) = (2 * (i % 48), 2 * (i / 48));
        let parts =
            [(x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1)].map(|(x, y)| twice[y * width + x]);
        let sum = |shift: u32| parts.iter().map(|part| part >> shift & 0xff).sum::<u32>();
        let [r, g, b] = [16, 8, 0].map(|shift| ((sum(shift) + 2) / 4) as u8);
        worst_channel(u32::from_be_bytes([0, r, g, b]), mean[*i]) > 1
    });
    // By rounding, rays that graze an edge hit or miss it.
    assert!(far.count() <= 2);
}

/// A white sphere that moves 4 units to the right within a second, 10 units away; and two that stand still at distances of 5 and
/// 20.
const SCENE: &str = "Scene(
    length: 2.0,
    camera: (eye: (0.0, 0.0, 10.0), look_at: (0.0, 0.0, 0.0), field_of_view: 0.4),
    ambient: (1.0, 1.0, 1.0),
    materials: {\"white\": (colour: (1.0, 1.0, 1.0))},
    spheres: [
        (centre: (-2.0, 0.0, 0.0), radius: 0.4, material: \"white\"),
        (centre: (0.0, 0.5, 5.0), radius: 0.1, material: \"white\"),
        (centre: (0.0, -2.0, -10.0), radius: 0.4, material: \"white\"),
    ],
    motions: [(of: \"spheres[0].centre\", keys: [(0.0, (-2.0, 0.0, 0.0)), (1.0, (2.0, 0.0, 0.0))])],
)";

/// Returns the brightness of the pixels of the first frame of [`SCENE`], 0 to 255.
fn frame(more: &str) -> Vec<u8> {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("scene.ron");
    fs::write(&file, SCENE).expect("it is written");
    let frames = folder.path().join("frames");
    let scene = file.display();
    let what = format!("--scene {scene} --size 96x64 --to 1 --fps 1 --quality exhaustive {more}");
    captured("--png", &frames, &what);
    let (_, pixels) = read_png(&files(&frames)[0].1);
    pixels.iter().map(|pixel| *pixel as u8).collect()
}

#[test]
fn shutter_blurs_motion_by_its_time() {
    let row = |picture: &[u8]| {
        let row = picture[32 * 96..][..96]
            .iter()
            .map(|&v| f64::from(v) / 255.0);
        let sum: f64 = row.clone().sum();
        let middle: f64 = row.enumerate().map(|(x, v)| x as f64 * v).sum();
        (sum, middle / sum)
    };
    // The pixels of a unit at the middle of the picture.
    let unit = 64.0 / (2.0 * 0.2_f64.tan() * 10.0);
    let (sum, start) = row(&frame(""));
    for (shutter, moved) in [(0.5, 1.0), (1.0, 2.0)] {
        let blurred = frame(&format!("--shutter {shutter} --supersample 16"));
        let (total, middle) = row(&blurred);
        assert!((total / sum - 1.0).abs() < 0.05, "{total}, {sum}");
        let way = middle - start;
        assert!((way - moved * unit).abs() < 0.6, "{way}, {unit}");
    }
}

#[test]
fn aperture_blurs_depths_out_of_focus() {
    // The pixels of each sphere that are neither black nor white.
    let grey = |more: &str| {
        let picture = frame(more);
        let of = |rows: std::ops::Range<usize>| {
            let pixels = &picture[rows.start * 96..rows.end * 96];
            pixels.iter().filter(|&&v| v > 25 && v < 230).count()
        };
        [of(0..24), of(24..40), of(40..64)]
    };
    let (pinhole, blurred) = (
        grey("--supersample 8"),
        grey("--supersample 8 --aperture 0.6"),
    );
    assert!(blurred[1] <= pinhole[1] + 12, "{blurred:?}, {pinhole:?}");
    for i in [0, 2] {
        assert!(blurred[i] > 2 * pinhole[i] + 12, "{blurred:?}, {pinhole:?}");
    }
}

#[test]
fn sheet_shows_frames_at_even_intervals() {
    let more = "--frames 6 --fps 4 --from 8 --to 32";
    let (width, sheet) = read_png(&lab(&line(&format!("--sheet - {more}"))).stdout);
    let rows: Vec<&[u32]> = sheet.chunks_exact(width).collect();
    assert_eq!(width, 12 + 3 * (48 + 12));
    for time in [2.5, 3.5, 4.5, 5.5, 6.5, 7.5] {
        let frame = rendered(&[time], "48x32");
        let row = &frame[16 * 48..][..48];
        let is_shown = rows
            .iter()
            .any(|sheet| sheet.windows(48).any(|part| part == row));
        assert!(is_shown, "{time}");
    }
}

#[test]
fn sound_is_the_frames_part_of_the_song() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("part.wav");
    // The machine begins at 56 s. If a frame begins between two samples, its sound begins with the second one.
    for (more, from, to) in [
        (
            "--scene show --fps 60 --from 600 --to 630",
            480_000,
            504_000,
        ),
        (
            "--scene show:machine --fps 50 --from 25 --to 75",
            2_712_000,
            2_760_000,
        ),
        ("--scene show --fps 7 --from 1 --to 2", 6858, 13_715),
    ] {
        captured("--audio", &file, more);
        let bytes = fs::read(&file).unwrap();
        assert!(bytes == wav::wav(&wav::record(from..to)), "{more}");
        let number = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
        assert_eq!(
            (&bytes[..4], &bytes[8..16]),
            (&b"RIFF"[..], &b"WAVEfmt "[..])
        );
        assert_eq!(
            [number(4), number(24), number(40)],
            [36 + 8 * (to - from), RATE, 8 * (to - from)]
        );
    }
}

/// Decodes a video.
fn decoded(file: &Path, how: &str) -> Vec<u8> {
    let mut ffmpeg = tool("ffmpeg");
    let input = ffmpeg.args(["-v", "error", "-i"]).arg(file);
    let (output, _) = run(input.args(how.split(' ')));
    assert!(
        output.status.success() && output.stderr.is_empty(),
        "{}",
        said(&output)
    );
    output.stdout
}

#[test]
fn video_has_all_frames_in_their_colours() {
    needs!(&["ffmpeg"]);
    let folder = tempfile::tempdir().unwrap();
    for name in ["show.mp4", "show.mkv"] {
        let file = folder.path().join(name);
        captured("--video", &file, "--fps 4 --to 3 --size 480x360");
        let rgb = decoded(&file, "-f rawvideo -pix_fmt rgb24 -");
        let pixel = |c: &[u8]| u32::from_be_bytes([0, c[0], c[1], c[2]]);
        let pixels: Vec<u32> = rgb.chunks_exact(3).map(pixel).collect();
        let wanted = rendered(&[0.0, 0.25, 0.5], "480x360");
        assert_eq!(pixels.len(), wanted.len(), "{name}");
        // With 4:2:0 the difference is 1.2. With the wrong matrix it is 2.2.
        let difference = Difference::between(&pixels, &wanted).mean;
        assert!(difference < 1.6, "{name}: {difference}");
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
}

#[test]
fn webp_repeats_all_frames() {
    needs!(&["ffmpeg"]);
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("show.webp");
    captured("--video", &file, "--to 2 --fps 4");
    let bytes = fs::read(file).unwrap();
    let chunks = |name: &[u8; 4]| bytes.windows(4).filter(|word| word == name).count();
    assert_eq!(chunks(b"ANMF"), 2, "frames");
    let animation = bytes.windows(4).position(|word| word == b"ANIM").unwrap();
    // The chunk's name, its length, the background; then the number of repeats, 0 for endless ones.
    assert_eq!(bytes[animation + 12..][..2], [0, 0]);
}

/// Writes a program that stands for ffmpeg into a folder.
fn write_ffmpeg(folder: &Path, script: &str) {
    let file = folder.join("ffmpeg");
    fs::write(&file, format!("#!/bin/sh\n{script}\n")).unwrap();
    fs::set_permissions(&file, fs::Permissions::from_mode(0o755)).unwrap();
}

#[test]
fn failing_ffmpeg_is_named_in_one_line() {
    let [folder, programs] = [(); 2].map(|()| tempfile::tempdir().unwrap());
    let video = folder.path().join("show.mp4");
    for (script, words) in [
        ("", ["--video", "apt-get install ffmpeg"]),
        (
            "echo 'no such encoder' >&2; exit 3",
            ["show.mp4", "no such encoder"],
        ),
        ("exit 0", ["ffmpeg", "ended early"]),
        // On a full disk it reports success.
        (
            "/bin/cat > /dev/null; echo 'no space' >&2",
            ["show.mp4", "no space"],
        ),
    ] {
        if !script.is_empty() {
            write_ffmpeg(programs.path(), script);
        }
        let mut command = command(&line(&format!("--video {} --to 99", video.display())));
        let output = command.env("PATH", programs.path()).output().unwrap();
        assert_one_line(&output, 1, &words);
        assert!(files(folder.path()).is_empty());
    }
}

#[cfg(target_os = "linux")]
#[test]
fn full_disk_leaves_no_broken_file() {
    let folder = tempfile::tempdir().unwrap();
    let frames = folder.path().join("frames");
    let output = limited(&line(&format!(
        "--png {} --to 9 --size 320x240",
        frames.display()
    )));
    assert_one_line(&output, 1, &["cannot write", "frame-000000.png"]);
    assert!(files(&frames).is_empty());
    let sound = lab(&line("--audio /dev/full --scene show --to 2"));
    assert_one_line(&sound, 1, &["/dev/full", "No space"]);
}

#[cfg(target_os = "linux")]
#[test]
fn signal_leaves_no_broken_file() {
    let [folder, programs] = [(); 2].map(|()| tempfile::tempdir().unwrap());
    write_ffmpeg(
        programs.path(),
        "echo $$ > \"$0.id\"; exec /bin/cat > /dev/null",
    );
    let (frames, video) = (folder.path().join("frames"), folder.path().join("show.mp4"));
    for (flag, target) in [("--png", &frames), ("--video", &video)] {
        let mut capture = command(&line(&format!("{flag} {}", target.display())));
        let output = interrupted(capture.env("PATH", programs.path()));
        assert_one_line(&output, 130, &["stopped early"]);
    }
    for (name, bytes) in files(&frames) {
        assert!(name.starts_with("frame-"), "{name}");
        read_png(&bytes);
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    let ffmpeg = fs::read_to_string(programs.path().join("ffmpeg.id")).unwrap_or_default();
    assert!(!signal(ffmpeg.trim(), "0"), "ffmpeg still runs");
}

#[test]
fn closed_pipe_is_named_in_one_line() {
    let mut capture = command(&line("--audio - --scene show --to 600"))
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut pipe = capture.stdout.take().unwrap();
    pipe.read_exact(&mut [0; 4]).unwrap();
    drop(pipe);
    let output = capture.wait_with_output().unwrap();
    assert_one_line(&output, 1, &["standard output", "pipe"]);
}
