//! A signal that asks for the end leaves no part of a file and no other program behind.

use super::{files, line, write_ffmpeg};
use crate::{assert_one_line, command, signal};
use eightfold_stage::reader::read_png;
use std::fs;
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::Child;
use std::thread::sleep;
use std::time::Duration;

/// Starts a capture of far too many frames as a group of processes, with the programs of a folder before others.
fn start(arguments: &str, programs: &Path) -> Child {
    let path = format!("{}:/usr/bin:/bin", programs.display());
    let mut lab = command(&line(&format!("--to 100000 {arguments}")));
    crate::start(lab.env("PATH", path).process_group(0))
}

/// The number of the program that stands for ffmpeg, once it has written it.
fn ffmpeg(programs: &Path) -> String {
    loop {
        let id = fs::read_to_string(programs.join("ffmpeg.id")).unwrap_or_default();
        if id.ends_with('\n') {
            return id.trim().to_owned();
        }
        sleep(Duration::from_millis(5));
    }
}

#[test]
fn no_part_of_a_file_is_left() {
    let folder = tempfile::tempdir().unwrap();
    for (name, code) in [("INT", 130), ("TERM", 143), ("HUP", 129)] {
        let frames = folder.path().join(name);
        let capture = start(&format!("--png {}", frames.display()), folder.path());
        let first = frames.join("frame-000000.png");
        while !first.exists() {
            sleep(Duration::from_millis(5));
        }
        assert!(signal(&capture.id().to_string(), name));
        let output = capture.wait_with_output().unwrap();
        assert_one_line(&output, code, &["stopped early"]);
        for (name, bytes) in files(&frames) {
            assert!(name.starts_with("frame-"), "{name}");
            assert_eq!(read_png(&bytes).1.len(), 48 * 32, "{name}");
        }
    }
}

#[test]
fn a_signal_ends_ffmpeg_too_whatever_that_is_at() {
    let [programs, folder] = [(); 2].map(|()| tempfile::tempdir().unwrap());
    let video = folder.path().join("show.mp4");
    for (script, times, group, name, code) in [
        // Without a signal it goes on when its input has ended.
        ("cat > /dev/null; exec sleep 60", 1, "", "TERM", 143),
        // It does not read, so that nothing more can be written to it after some frames.
        ("exec sleep 60", 1, "", "INT", 130),
        // A terminal sends it to all processes of the group. What ffmpeg says then is no error.
        ("while read -r _; do :; done", 6, "-", "INT", 130),
    ] {
        let trap = "trap 'echo interrupted >&2; exit 255' INT";
        write_ffmpeg(
            programs.path(),
            &format!("{trap}; echo $$ > \"$0.id\"; {script}"),
        );
        for _ in 0..times {
            let capture = start(&format!("--video {}", video.display()), programs.path());
            let ffmpeg = ffmpeg(programs.path());
            // Time for the pipe to fill.
            sleep(Duration::from_millis(200));
            assert!(signal(&format!("{group}{}", capture.id()), name));
            let output = capture.wait_with_output().unwrap();
            assert_one_line(&output, code, &["stopped early"]);
            assert!(files(folder.path()).is_empty());
            assert!(!signal(&ffmpeg, "0"), "{script} still runs");
            fs::remove_file(programs.path().join("ffmpeg.id")).unwrap();
        }
    }
}

#[test]
fn a_second_signal_leaves_no_part_of_a_file() {
    let [programs, folder] = [(); 2].map(|()| tempfile::tempdir().unwrap());
    write_ffmpeg(programs.path(), "exec cat > /dev/null");
    let video = folder.path().join("show.mp4");
    // No frame is done before the second one.
    let slow = "--size 3840x2160 --quality exhaustive --supersample 16";
    let capture = start(
        &format!("--video {} {slow}", video.display()),
        programs.path(),
    );
    while files(folder.path()).is_empty() {
        sleep(Duration::from_millis(5));
    }
    assert!(signal(&capture.id().to_string(), "INT"));
    // Two that come together are one.
    sleep(Duration::from_millis(100));
    assert!(signal(&capture.id().to_string(), "TERM"));
    let output = capture.wait_with_output().unwrap();
    assert_one_line(&output, 143, &["stopped at once"]);
    assert!(files(folder.path()).is_empty());
}

#[test]
fn the_sound_alone_is_ended_by_a_signal_too() {
    let folder = tempfile::tempdir().unwrap();
    let sound = folder.path().join("show.wav");
    let all = format!("--audio {} --scene show", sound.display());
    let capture = start(&all, folder.path());
    assert!(signal(&capture.id().to_string(), "INT"));
    let output = capture.wait_with_output().unwrap();
    assert_one_line(&output, 130, &["stopped"]);
    assert!(files(folder.path()).is_empty());
}

#[test]
fn an_ffmpeg_that_ends_early_is_named() {
    let folder = tempfile::tempdir().unwrap();
    write_ffmpeg(folder.path(), "exit 0");
    let video = folder.path().join("show.mp4");
    let capture = start(&format!("--video {}", video.display()), folder.path());
    let output = capture.wait_with_output().unwrap();
    assert_one_line(&output, 1, &["show.mp4", "ffmpeg", "ended"]);
    assert_eq!(files(folder.path()).len(), 1, "ffmpeg alone");
}
