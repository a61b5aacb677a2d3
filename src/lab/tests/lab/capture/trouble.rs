//! Bad input, full disks and closed pipes lead to one line of explanation and no broken files.

use super::{capture, files, line, write_ffmpeg};
use crate::{assert_one_line, command};
use eightfold_stage::needs;
use std::fs;
use std::io::Read;
use std::process::{Output, Stdio};

/// Captures into files of 1 KiB at most.
fn limited(arguments: &str) -> Output {
    crate::limited(&line(arguments))
}

#[test]
fn bad_input_is_named_in_one_line() {
    for (flags, words) in [
        ("", "--png --video --sheet --audio"),
        ("--png x --video y.mp4", "--png --video"),
        ("--sheet - --fps 0", "--fps 0 30000/1001"),
        ("--sheet - --fps 60/0", "--fps 60/0 30000/1001"),
        ("--sheet - --fps 1001", "--fps 1001 1000"),
        ("--sheet - --fps fast", "--fps fast 60"),
        ("--sheet - --from -1", "--from"),
        ("--sheet - --from x", "--from number frame"),
        ("--sheet - --from 1508", "--from 1508 0 1507"),
        ("--sheet - --from 5 --to 5", "--to 5 --from"),
        ("--sheet - --to 100001", "--to 100000"),
        ("--sheet - --supersample 0", "--supersample 1 16"),
        ("--sheet - --supersample 17", "--supersample 1 16"),
        ("--png x --frames 5", "--frames --png"),
        ("--video x.avi", "--video x.avi .mp4 .mkv"),
        ("--video x.mp4 --size 33x32", "--size 33x32 even --video"),
        ("--sheet - --scene show --from 6960", "--from 6960 0 6959"),
        ("--audio - --scene model", "--audio show model"),
        ("--audio - --sheet - --scene show", "--audio - output"),
        ("--sheet - --frames 0", "--frames 1"),
        ("--sheet - --frames 9 --to 5", "--frames 9 5"),
        ("--sheet - --size 3840x2160", "--size 3840x2160 16384"),
        ("--sheet - --shutter 1.5", "--shutter 0 to 1"),
        ("--sheet - --shutter -1", "--shutter share"),
        ("--sheet - --aperture 0", "--aperture length above"),
        ("--sheet - --aperture wide", "--aperture length"),
        ("--sheet - --focus 3", "--aperture"),
        ("--sheet - --aperture 1 --focus nan", "--focus length"),
        ("--sheet - --samples 0", "--samples 1 4096"),
        ("--sheet - --samples 4097", "--samples 1 4096"),
        (
            "--sheet - --samples 4 --supersample 2",
            "--samples --supersample",
        ),
    ] {
        let words: Vec<&str> = words.split(' ').collect();
        assert_one_line(&capture(flags), 2, &words);
    }
}

#[test]
fn a_full_disk_is_named_in_one_line_and_leaves_no_broken_file() {
    let folder = tempfile::tempdir().unwrap();
    let name = |name: &str| folder.path().join(name).display().to_string();
    let many = "--to 9 --size 320x240";
    let output = limited(&format!("--png {} {many}", name("frames")));
    assert_one_line(&output, 1, &["frame-00000", "cannot write"]);
    assert!(files(&folder.path().join("frames")).is_empty());
    let sheet = name("sheet.png");
    let output = limited(&format!("--sheet {sheet} {many} --frames 4"));
    assert_one_line(&output, 1, &["sheet.png", "cannot write"]);
    let left: Vec<_> = fs::read_dir(folder.path()).unwrap().collect();
    assert_eq!(left.len(), 1, "{left:?}");
    assert_one_line(
        &capture("--audio /dev/full --scene show --to 2"),
        1,
        &["/dev/full", "No space"],
    );
}

#[test]
fn a_video_on_a_full_disk_is_named_in_one_line_and_leaves_no_broken_file() {
    needs!(&["ffmpeg"]);
    let folder = tempfile::tempdir().unwrap();
    let video = folder.path().join("show.mp4");
    let output = limited(&format!("--video {} --to 9", video.display()));
    assert_one_line(&output, 1, &["show.mp4", "ffmpeg"]);
    assert!(files(folder.path()).is_empty());
}

#[test]
fn a_pipe_that_is_closed_is_named_in_one_line() {
    let mut capture = command(&line("--audio - --scene show --to 600"))
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut begin = [0; 4];
    let mut pipe = capture.stdout.take().unwrap();
    pipe.read_exact(&mut begin).unwrap();
    drop(pipe);
    assert_eq!(&begin, b"RIFF");
    let output = capture.wait_with_output().unwrap();
    assert_one_line(&output, 1, &["standard output", "pipe"]);
}

#[test]
fn without_ffmpeg_it_says_how_to_get_it() {
    let folder = tempfile::tempdir().unwrap();
    let video = folder.path().join("show.mp4");
    let output = command(&line(&format!("--video {} --to 2", video.display())))
        .env("PATH", folder.path())
        .output()
        .unwrap();
    let words = ["--video", "ffmpeg", "apt-get install", "--png"];
    assert_one_line(&output, 1, &words);
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn a_video_that_ffmpeg_cannot_make_is_named_in_one_line() {
    let folder = tempfile::tempdir().unwrap();
    write_ffmpeg(folder.path(), "echo 'no such encoder' >&2; exit 3");
    let video = folder.path().join("show.mp4");
    let output = command(&line(&format!("--video {} --to 99", video.display())))
        .env("PATH", folder.path())
        .output()
        .unwrap();
    assert_one_line(&output, 1, &["show.mp4", "no such encoder"]);
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}
