//! The sound of frames: of the same times, and in step with them in a video.

use super::captured;
use crate::{lab, stage};
use eightfold::show::grid::{self, BAR};
use eightfold::sound::RATE;
use std::fs;
use std::path::Path;

/// Bytes of a WAV file before its samples, and of a sample of both sides.
const HEADER: usize = 58;
const SAMPLE: usize = 8;

/// Frames a second of the videos.
const FPS: usize = 60;

#[test]
fn the_sound_of_frames_is_their_part_of_the_soundtrack() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let song = lab(&["sound", "--wav", "-"]).stdout;
    // The machine begins at 60 s; a frame that begins between two samples is heard from the second one on.
    for (more, from, to) in [
        (
            "--scene show --fps 60 --from 600 --to 630",
            480_000,
            504_000,
        ),
        (
            "--scene show:machine --fps 50 --from 25 --to 75",
            2_904_000,
            2_952_000,
        ),
        ("--scene show --fps 7 --from 1 --to 2", 6858, 13_715),
        ("--scene show", 0, 96 * 48_000),
    ] {
        captured("--audio", &path("part.wav"), more);
        let part = fs::read(path("part.wav")).unwrap();
        assert_eq!(part.len(), HEADER + (to - from) * SAMPLE, "{more}");
        let wanted = &song[HEADER..][from * SAMPLE..to * SAMPLE];
        assert!(part[HEADER..] == *wanted, "{more}");
    }
    // Beside pictures, too.
    let (frames, wav) = (path("frames"), path("both.wav"));
    let more = "--scene show --fps 60 --from 600 --to 603 --audio";
    captured("--png", &frames, &format!("{more} {}", wav.display()));
    assert_eq!(fs::read_dir(&frames).unwrap().count(), 3);
    let bytes = fs::metadata(&wav).unwrap().len();
    assert_eq!(bytes as usize, HEADER + 3 * 800 * SAMPLE);
}

/// What a player makes of a file, in raw form: all of it is placed by the times that it has in the file.
fn decoded(file: &Path, how: &str) -> Vec<u8> {
    let mut ffmpeg = stage::tool("ffmpeg");
    let (output, _) = stage::run(
        ffmpeg
            .args(["-v", "error", "-i"])
            .arg(file)
            .args(how.split(' ')),
    );
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && errors.is_empty(), "{errors}");
    output.stdout
}

/// The seconds from a video's start to the moment when its picture changes most.
fn cut(video: &Path, pixels: usize) -> f64 {
    let grey = decoded(video, "-vsync cfr -r 60 -f rawvideo -pix_fmt gray -");
    let frames: Vec<&[u8]> = grey.chunks_exact(pixels).collect();
    let change = |pair: &[&[u8]]| -> u32 {
        let both = pair[0].iter().zip(pair[1]);
        both.map(|(a, b)| u32::from(a.abs_diff(*b))).sum()
    };
    let changes = frames.windows(2).map(change).enumerate();
    let (last, _) = changes.max_by_key(|(_, change)| *change).expect("frames");
    (last + 1) as f64 / FPS as f64
}

/// The seconds from a video's start to where its sound rises most within 60 ms of a time: where a kick begins. Treble
/// tells, of which the beginning of a kick has more than all of the rest.
fn onset(video: &Path, around: f64) -> f64 {
    /// Samples of a millisecond, and the milliseconds before and after a time that are compared.
    const MS: usize = RATE as usize / 1000;
    const SPAN: usize = 8;
    let how = "-af aresample=async=1:first_pts=0 -f f32le -ac 1 -ar 48000 -";
    let samples: Vec<f32> = decoded(video, how)
        .chunks_exact(4)
        .map(|bytes| f32::from_le_bytes(bytes.try_into().expect("four bytes")))
        .collect();
    let slopes: Vec<f32> = samples.windows(2).map(|w| (w[1] - w[0]).powi(2)).collect();
    let energies: Vec<f32> = slopes.chunks(MS).map(|ms| ms.iter().sum()).collect();
    let rise = |at: usize| {
        let sum = |from: usize| energies[from..from + SPAN].iter().sum::<f32>();
        sum(at) - sum(at - SPAN)
    };
    let middle = (around * 1e3) as usize;
    let steepest = (middle - 60..middle + 60).max_by(|&a, &b| rise(a).total_cmp(&rise(b)));
    steepest.expect("a time") as f64 / 1e3
}

/// The seconds from a video's start to the moment when its picture gets brighter most, within 60 ms and two frames of a
/// time.
fn flash(brightness: &[f64], around: f64) -> f64 {
    let rise = |frame: usize| brightness[frame] - brightness[frame - 1];
    let middle = (around * FPS as f64).round() as usize;
    let steepest = (middle - 6..=middle + 6).max_by(|&a, &b| rise(a).total_cmp(&rise(b)));
    steepest.expect("a frame") as f64 / FPS as f64
}

/// The lamps of the machine flash on the kick, and nothing else is cut there.
#[test]
fn a_flash_in_a_video_lies_within_a_frame_of_the_kick_that_is_heard() {
    if stage::lacks(&["ffmpeg"]) {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let video = folder.path().join("machine.mp4");
    // From the machine's second bar on, two bars; their beats are counted from a quarter of a second before.
    let start = BAR * (grid::MACHINE + 1) as f32 - 0.25;
    let from = (start * FPS as f32) as usize;
    let more = format!(
        "--scene show --size 64x36 --from {from} --to {}",
        from + 4 * FPS
    );
    captured("--video", &video, &more);
    let grey = decoded(&video, "-vsync cfr -r 60 -f rawvideo -pix_fmt gray -");
    let mean = |frame: &[u8]| frame.iter().map(|&grey| f64::from(grey)).sum::<f64>() / 2304.0;
    let brightness: Vec<f64> = grey.chunks_exact(64 * 36).map(mean).collect();
    let mut kicks = 0;
    for beat in 0..7 {
        let time = 0.25 + grid::BEAT * beat as f32;
        if eightfold::sound::pulse(start + time).kick < 0.9 {
            continue;
        }
        kicks += 1;
        let flash = flash(&brightness, time.into());
        let onset = onset(&video, time.into());
        println!("beat {beat}: flash at {flash} s, kick at {onset} s");
        assert!(
            (flash - onset).abs() <= 1.0 / FPS as f64,
            "beat {beat}: flash at {flash} s, kick at {onset} s"
        );
    }
    assert!(kicks >= 4, "{kicks} kicks");
}

/// Two scenes begin on a kick, with a picture that is another one from a frame to the next.
#[test]
fn picture_and_sound_of_a_video_are_in_step() {
    if stage::lacks(&["ffmpeg"]) {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    for (name, bar) in [("model.mp4", grid::MODEL), ("field.mkv", grid::SWARM)] {
        assert_eq!(eightfold::sound::pulse(BAR * bar as f32).kick, 1.0);
        let video = folder.path().join(name);
        // Half a second before it, and half a second from there.
        let first = (BAR * bar as f32) as usize * FPS - FPS / 2;
        let last = first + FPS;
        let more = format!("--scene show --size 64x36 --from {first} --to {last}");
        captured("--video", &video, &more);
        let cut = cut(&video, 64 * 36);
        // Matroska begins with the 21 ms of silence that AAC needs to begin, before picture and sound alike.
        let late = cut - 0.5;
        assert!((-1e-6..0.022).contains(&late), "{name}: {cut} s");
        let onset = onset(&video, cut);
        assert!(
            (onset - cut).abs() <= 1.0 / FPS as f64,
            "{name}: picture at {cut} s, sound at {onset} s"
        );
    }
}
