//! Captured sound belongs to the captured frames, and is in sync with them in a video.

use super::captured;
use crate::lab;
use eightfold::show::{
    self,
    grid::{self, BAR},
};
use eightfold::sound::{RATE, SONG_LENGTH};
use eightfold_stage::{needs, run, tool};
use std::fs;
use std::path::Path;

/// The bytes of a WAV header, and of a sample of both channels.
const HEADER: usize = 58;
const SAMPLE: usize = 8;

/// The frame rate of the videos, in frames per second.
const FPS: usize = 60;

#[test]
fn the_sound_of_frames_is_their_part_of_the_soundtrack() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let song = lab("sound --wav -").stdout;
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
        ("--scene show", 0, SONG_LENGTH as usize),
    ] {
        captured("--audio", &path("part.wav"), more);
        let part = fs::read(path("part.wav")).unwrap();
        assert_eq!(part.len(), HEADER + (to - from) * SAMPLE, "{more}");
        let wanted = &song[HEADER..][from * SAMPLE..to * SAMPLE];
        assert!(part[HEADER..] == *wanted, "{more}");
    }
    // Also together with pictures.
    let (frames, wav) = (path("frames"), path("both.wav"));
    let more = "--scene show --fps 60 --from 600 --to 603 --audio";
    captured("--png", &frames, &format!("{more} {}", wav.display()));
    assert_eq!(fs::read_dir(&frames).unwrap().count(), 3);
    let bytes = fs::metadata(&wav).unwrap().len();
    assert_eq!(bytes as usize, HEADER + 3 * 800 * SAMPLE);
}

/// Decodes a file as a player does, respecting its time stamps.
fn decoded(file: &Path, how: &str) -> Vec<u8> {
    let mut ffmpeg = tool("ffmpeg");
    let (output, _) = run(ffmpeg
        .args(["-v", "error", "-i"])
        .arg(file)
        .args(how.split(' ')));
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && errors.is_empty(), "{errors}");
    output.stdout
}

/// The time, in seconds, of the largest change of a video's picture.
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

/// The time, in seconds, of the steepest rise of a video's treble within 60 ms of a given time: the start of a kick, which has
/// more treble than everything else.
fn onset(video: &Path, around: f64) -> f64 {
    /// The samples of a millisecond, and the milliseconds compared before and after a time.
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

/// The time, in seconds, at which a video's picture brightens most, within 60 ms and two frames of a given time.
fn flash(brightness: &[f64], around: f64) -> f64 {
    let rise = |frame: usize| brightness[frame] - brightness[frame - 1];
    let middle = (around * FPS as f64).round() as usize;
    let steepest = (middle - 6..=middle + 6).max_by(|&a, &b| rise(a).total_cmp(&rise(b)));
    steepest.expect("a frame") as f64 / FPS as f64
}

/// In the machine the lights flash on the kick, and there are no cuts.
#[test]
fn a_flash_in_a_video_lies_within_a_frame_of_the_kick_that_is_heard() {
    needs!(&["ffmpeg"]);
    let folder = tempfile::tempdir().unwrap();
    let video = folder.path().join("machine.mp4");
    // Two bars from the second bar of the machine, captured from a quarter of a second before.
    let start = BAR * (show::cut("machine") + 1) as f32 - 0.25;
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

/// Two scenes begin with a kick and a cut.
#[test]
fn picture_and_sound_of_a_video_are_in_step() {
    needs!(&["ffmpeg"]);
    let folder = tempfile::tempdir().unwrap();
    for (name, bar) in [
        ("model.mp4", show::cut("model")),
        ("field.mkv", show::cut("swarm")),
    ] {
        assert_eq!(eightfold::sound::pulse(BAR * bar as f32).kick, 1.0);
        let video = folder.path().join(name);
        // From half a second before the cut to half a second after it.
        let first = (BAR * bar as f32) as usize * FPS - FPS / 2;
        let last = first + FPS;
        let more = format!("--scene show --size 64x36 --from {first} --to {last}");
        captured("--video", &video, &more);
        let cut = cut(&video, 64 * 36);
        // Matroska files start with the 21 ms of silence that AAC needs, for picture and sound alike.
        let late = cut - 0.5;
        assert!((-1e-6..0.022).contains(&late), "{name}: {cut} s");
        let onset = onset(&video, cut);
        assert!(
            (onset - cut).abs() <= 1.0 / FPS as f64,
            "{name}: picture at {cut} s, sound at {onset} s"
        );
    }
}
