use super::{assert_one_line, command, picture, printed, signal, signalled, stderr};
use eightfold::show;
use eightfold::sound::RATE;
use eightfold_harness::error::{Difference, worst_channel};
use eightfold_harness::picture::from_rgb;
use eightfold_lab::capture::{record, wav};
use eightfold_stage::{needs, reader::read_png, run, tool};
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};

fn line(arguments: &str) -> String {
    let defaults = [("--size", "48x32"), ("--scene", "model")];
    let mut line = format!("capture {arguments}");
    for (flag, word) in defaults.iter().filter(|it| !arguments.contains(it.0)) {
        line += &format!(" {flag} {word}");
    }
    line
}

#[track_caller]
fn captured(flag: &str, target: &Path, more: &str) {
    printed(&line(&format!("{flag} {} {more}", target.display())));
}

fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let entries = fs::read_dir(folder).expect("a folder");
    let file = |path: PathBuf| {
        let name = path.file_name().expect("a name").display().to_string();
        (name, fs::read(path).expect("a file"))
    };
    let mut files: Vec<_> = entries.map(|it| file(it.unwrap().path())).collect();
    files.sort();
    files
}

fn rendered(times: &[f64], size: &str) -> Vec<u32> {
    let line = |time: &f64| format!("render --size {size} --time {time} --out -");
    times.iter().flat_map(|time| picture(&line(time)).1).collect()
}

#[test]
fn frames_match_rendered_times() {
    let folder = tempfile::tempdir().unwrap();
    captured("--png", folder.path(), "--fps 4 --from 10 --to 12");
    let files = files(folder.path());
    assert_eq!(files[0].0, "frame-000010.png");
    let frames = files.iter().flat_map(|(_, bytes)| read_png(bytes).1);
    assert!(frames.eq(rendered(&[2.5, 2.75], "48x32")));
}

#[test]
fn default_range_is_scene() {
    for (scene, seconds) in
        [("show --to 99999", show::LENGTH), ("model", show::MODEL_LENGTH.ceil())]
    {
        let folder = tempfile::tempdir().unwrap();
        let more = format!("--fps 1 --size 8x8 --scene {scene}");
        captured("--png", folder.path(), &more);
        assert_eq!(files(folder.path()).len(), seconds as usize);
    }
}

#[test]
fn supersampled_pixel_is_mean_of_parts() {
    let folder = tempfile::tempdir().unwrap();
    let more = "--to 1 --quality exhaustive --supersample 2";
    captured("--png", folder.path(), more);
    let (_, mean) = read_png(&files(folder.path())[0].1);
    let (width, twice) = picture("render --size 96x64 --out - --quality exhaustive");
    let far = (0..mean.len()).filter(|i| {
        let (x, y) = (2 * (i % 48), 2 * (i / 48));
        let parts =
            [(x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1)].map(|(x, y)| twice[y * width + x]);
        let sum = |shift: u32| parts.iter().map(|part| part >> shift & 0xff).sum::<u32>();
        let [r, g, b] = [16, 8, 0].map(|shift| ((sum(shift) + 2) / 4) as u8);
        worst_channel(u32::from_be_bytes([0, r, g, b]), mean[*i]) > 1
    });
    // Rounding decides whether grazing rays hit.
    assert!(far.count() <= 2);
}

/// White spheres: the one 10 units away moves right by 4 units per second; those 5 and 20 units
/// away do not move.
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

fn frame(more: &str) -> Vec<u8> {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("scene.ron");
    fs::write(&file, SCENE).expect("it is written");
    let frames = folder.path().join("frames");
    let more = format!("{more} --scene {}", file.display());
    let more = format!("--size 96x64 --to 1 --fps 1 --quality exhaustive {more}");
    captured("--png", &frames, &more);
    let (_, pixels) = read_png(&files(&frames)[0].1);
    pixels.iter().map(|pixel| *pixel as u8).collect()
}

#[test]
fn shutter_blurs_motion() {
    let row = |picture: &[u8]| {
        let row = picture[32 * 96..][..96].iter().map(|&v| f64::from(v));
        let sum: f64 = row.clone().sum();
        let middle: f64 = row.enumerate().map(|(x, v)| x as f64 * v).sum();
        (sum, middle / sum)
    };
    // Pixels per scene unit.
    let unit = 64.0 / (2.0 * 0.2_f64.tan() * 10.0);
    let (sum, start) = row(&frame(""));
    for (shutter, moved) in [(0.5, 1.0), (1.0, 2.0)] {
        let blurred = frame(&format!("--shutter {shutter} --supersample 16"));
        let (total, middle) = row(&blurred);
        assert!((total / sum - 1.0).abs() < 0.05, "{total}, {sum}");
        let distance = middle - start;
        assert!((distance - moved * unit).abs() < 0.6, "{distance}, {unit}");
    }
}

#[test]
fn aperture_blurs_out_of_focus() {
    let grey = |more: &str| {
        let picture = frame(&format!("--supersample 8 {more}"));
        [0..24, 24..40, 40..64].map(|rows| {
            let pixels = &picture[rows.start * 96..rows.end * 96];
            pixels.iter().filter(|&&v| v > 25 && v < 230).count()
        })
    };
    let (pinhole, blurred) = (grey(""), grey("--aperture 0.6"));
    assert!(blurred[1] <= pinhole[1] + 12, "{blurred:?}, {pinhole:?}");
    for i in [0, 2] {
        assert!(blurred[i] > 2 * pinhole[i] + 12, "{blurred:?}, {pinhole:?}");
    }
}

#[test]
fn sheet_shows_frames_at_even_intervals() {
    let more = "--frames 6 --fps 4 --from 8 --to 32";
    let (width, sheet) = picture(&line(&format!("--sheet - {more}")));
    let rows: Vec<&[u32]> = sheet.chunks_exact(width).collect();
    assert_eq!(width, 12 + 3 * (48 + 12));
    for time in [2.5, 3.5, 4.5, 5.5, 6.5, 7.5] {
        let frame = rendered(&[time], "48x32");
        let row = &frame[16 * 48..][..48];
        let mut parts = rows.iter().flat_map(|sheet| sheet.windows(48));
        assert!(parts.any(|part| part == row), "{time}");
    }
}

#[test]
fn sound_matches_frames() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("part.wav");
    // The chimes begin at 56 s. A frame's sound begins at the first sample at or after the frame's
    // time.
    for (more, from, to) in [
        ("show:chimes --fps 2 --from 1 --to 3", 2_712_000, 2_760_000),
        ("show --fps 7 --from 1 --to 2", 6858, 13_715),
    ] {
        captured("--audio", &file, &format!("--scene {more}"));
        let bytes = fs::read(&file).unwrap();
        assert!(bytes == wav(&record(from..to)), "{more}");
        let number = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
        assert!(bytes.starts_with(b"RIFF") && bytes[8..].starts_with(b"WAVEfmt "));
        let size = 8 * (to - from);
        assert_eq!([number(4), number(24), number(40)], [36 + size, RATE, size]);
    }
}

#[test]
fn video_has_frames_in_their_colours() {
    needs!(&["ffmpeg"]);
    let folder = tempfile::tempdir().unwrap();
    for name in ["show.mp4", "show.mkv"] {
        let file = folder.path().join(name);
        captured("--video", &file, "--fps 4 --to 3 --size 480x360");
        let mut ffmpeg = tool("ffmpeg");
        let input = ffmpeg.args(["-v", "error", "-i"]).arg(file);
        let rgb = run(input.args(["-f", "rawvideo", "-pix_fmt", "rgb24", "-"])).0.stdout;
        let pixels = from_rgb(&rgb);
        let wanted = rendered(&[0.0, 0.25, 0.5], "480x360");
        assert_eq!(pixels.len(), wanted.len(), "{name}");
        // Chroma subsampling (4:2:0) causes a difference of 1.2, a wrong colour matrix 2.2.
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
    // After the chunk's name, length and background: 0 repeats for ever.
    assert_eq!(bytes[animation + 12..][..2], [0, 0]);
}

fn write_ffmpeg(folder: &Path, script: &str) {
    let file = folder.join("ffmpeg");
    fs::write(&file, format!("#!/bin/sh\n{script}\n")).unwrap();
    fs::set_permissions(&file, fs::Permissions::from_mode(0o755)).unwrap();
}

#[test]
fn failing_ffmpeg_is_reported_in_one_line() {
    let [folder, programs] = [(); 2].map(|()| tempfile::tempdir().unwrap());
    let video = folder.path().join("show.mp4");
    for (script, words) in [
        ("", ["ffmpeg cannot be started", "apt-get install ffmpeg"]),
        (
            "echo '[mp4 @ 0x5f] no codec' >&2; echo later >&2; exit 3",
            ["show.mp4: ffmpeg", "write: no codec"],
        ),
        ("exit 0", ["ffmpeg", "ended early"]),
        ("/bin/cat > /dev/null; echo full >&2", ["show.mp4", "full"]),
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

#[test]
fn ignored_hang_up_does_not_end_frames() {
    let folder = tempfile::tempdir().unwrap();
    let ignoring = "trap '' HUP; \"$0\" \"$@\" & kill -s HUP $!; wait $!";
    let mut sh = std::process::Command::new("sh");
    let sh = sh.args(["-c", ignoring, env!("CARGO_BIN_EXE_lab")]);
    let frames =
        format!("capture --scene model --size 8x8 --to 9 --png {}", folder.path().display());
    let (output, _) = run(sh.args(frames.split(' ')));
    assert!(output.status.success(), "{}", stderr(&output));
    assert_eq!(files(folder.path()).len(), 9);
}

#[test]
fn signal_leaves_no_broken_file() {
    let [folder, programs] = [(); 2].map(|()| tempfile::tempdir().unwrap());
    write_ffmpeg(programs.path(), "echo $$ > \"$0.id\"; exec /bin/cat > /dev/null");
    let (frames, video) = (folder.path().join("frames"), folder.path().join("show.mp4"));
    for (flag, target, name, number) in
        [("--png", &frames, "INT", 2), ("--video", &video, "HUP", 1), ("--video", &video, "INT", 2)]
    {
        let mut capture = command(&line(&format!("{flag} {}", target.display())));
        let output = signalled(capture.env("PATH", programs.path()), name, number);
        assert_one_line(&output, 130, &["interrupted"]);
    }
    for (name, bytes) in files(&frames) {
        assert!(name.starts_with("frame-"), "{name}");
        read_png(&bytes);
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    let ffmpeg = fs::read_to_string(programs.path().join("ffmpeg.id")).unwrap_or_default();
    assert!(!signal(ffmpeg.trim(), "0"), "ffmpeg still runs");
}
