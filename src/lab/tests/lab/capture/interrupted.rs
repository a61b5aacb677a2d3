//! A signal that asks for the end leaves no part of a file and no other program behind.

use super::{files, flags};
use crate::assert_one_line;
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

/// Writes a program that stands for ffmpeg into a folder.
fn write_ffmpeg(folder: &Path, script: &str) {
    let ffmpeg = folder.join("ffmpeg");
    fs::write(&ffmpeg, format!("#!/bin/sh\n{script}\n")).unwrap();
    fs::set_permissions(&ffmpeg, fs::Permissions::from_mode(0o755)).unwrap();
}

/// Starts a capture of far too many frames, with the programs of a folder before others.
fn start(arguments: &str, programs: &Path) -> Child {
    let path = format!("{}:/usr/bin:/bin", programs.display());
    Command::new(env!("CARGO_BIN_EXE_lab"))
        .args(flags(&format!("--to 100000 {arguments}")))
        .env("PATH", path)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

fn signal(process: &str, name: &str) -> bool {
    let kill = format!("kill -{name} {process}");
    let mut sh = Command::new("sh");
    let status = sh.args(["-c", &kill]).stderr(Stdio::null()).status();
    status.unwrap().success()
}

#[test]
fn no_part_of_a_file_is_left() {
    let folder = tempfile::tempdir().unwrap();
    for (name, code) in [("INT", 130), ("TERM", 143), ("HUP", 129)] {
        let stream = folder.path().join("show.y4m");
        let capture = start(&format!("--y4m {}", stream.display()), folder.path());
        while files(folder.path()).is_empty() {
            sleep(Duration::from_millis(5));
        }
        assert!(signal(&capture.id().to_string(), name));
        let output = capture.wait_with_output().unwrap();
        assert_one_line(&output, code, &["stopped early"]);
        assert!(files(folder.path()).is_empty(), "{name}");
    }
}

#[test]
fn ffmpeg_does_not_outlive_it() {
    let [programs, folder] = [(); 2].map(|()| tempfile::tempdir().unwrap());
    // Without a signal it goes on when its input has ended.
    write_ffmpeg(
        programs.path(),
        "echo $$ > \"$0.id\"; cat > /dev/null; exec sleep 60",
    );
    let video = folder.path().join("show.mp4");
    let capture = start(&format!("--video {}", video.display()), programs.path());
    let id: PathBuf = programs.path().join("ffmpeg.id");
    let ffmpeg = loop {
        let id = fs::read_to_string(&id).unwrap_or_default();
        if id.ends_with('\n') {
            break id;
        }
        sleep(Duration::from_millis(5));
    };
    assert!(signal(&capture.id().to_string(), "TERM"));
    let output = capture.wait_with_output().unwrap();
    assert_one_line(&output, 143, &["stopped early"]);
    assert!(files(folder.path()).is_empty());
    assert!(!signal(ffmpeg.trim(), "0"), "it still runs");
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
