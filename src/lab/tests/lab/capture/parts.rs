//! Parts of a capture equal the whole, and existing frames are kept.

use super::{captured, files, line};
use crate::command;
use eightfold_stage::reader::read_png;
use std::fs;
use std::process::Stdio;

#[test]
fn two_halves_are_the_whole_bit_for_bit() {
    let folder = tempfile::tempdir().unwrap();
    let (whole, halves) = (folder.path().join("whole"), folder.path().join("halves"));
    for what in ["", "--supersample 2 --quality thesis --fps 24000/1001"] {
        for (folder, more) in [
            (&whole, "--from 3 --to 12 --threads 3"),
            (&halves, "--from 7 --to 12 --threads 1"),
            (&halves, "--from 3 --to 7 --threads 2"),
        ] {
            captured("--png", folder, &format!("{more} {what}"));
        }
        let whole = files(&whole);
        assert_eq!(whole.len(), 9);
        assert_eq!(whole[0].0, "frame-000003.png");
        assert!(whole == files(&halves), "{what}");
    }
}

#[cfg(target_arch = "x86_64")]
#[test]
fn machines_with_avx2_and_with_avx512_draw_the_same_bytes() {
    if !is_x86_feature_detected!("avx2") {
        // On other machines the instruction set has to be named.
        let output = super::lab("capture --sheet -");
        return crate::assert_one_line(&output, 2, &["--isa", "sse2"]);
    }
    let folder = tempfile::tempdir().unwrap();
    let (best, avx2) = (folder.path().join("best"), folder.path().join("avx2"));
    for what in ["--scene field:64", "--quality exhaustive --size 111x70"] {
        captured("--png", &best, &format!("--to 5 {what}"));
        captured("--png", &avx2, &format!("--to 5 {what} --isa avx2"));
        assert!(files(&best) == files(&avx2), "{what}");
    }
}

#[test]
fn frames_that_are_there_whole_are_kept() {
    let folder = tempfile::tempdir().unwrap();
    captured("--png", folder.path(), "--to 6");
    let whole = files(folder.path());
    let path = |n: usize| folder.path().join(&whole[n].0);
    // One file is missing, one is truncated, one has a flipped bit.
    fs::remove_file(path(1)).unwrap();
    fs::write(path(2), &whole[2].1[..whole[2].1.len() - 20]).unwrap();
    let mut turned = whole[3].1.clone();
    let middle = turned.len() / 2;
    turned[middle] ^= 4;
    fs::write(path(3), turned).unwrap();
    let before = fs::metadata(path(4)).unwrap().modified().unwrap();
    let said = captured("--png", folder.path(), "--to 6");
    assert!(said.contains("3 frames drawn, 3 kept"), "{said}");
    assert!(files(folder.path()) == whole);
    assert_eq!(fs::metadata(path(4)).unwrap().modified().unwrap(), before);
}

#[test]
fn frames_of_another_capture_are_not_kept() {
    let folder = tempfile::tempdir().unwrap();
    captured("--png", folder.path(), "--to 2");
    for other in [
        "--fps 50",
        "--size 48x33",
        "--quality exhaustive",
        "--scene field:9",
        "--supersample 3",
    ] {
        let said = captured("--png", folder.path(), &format!("--to 2 {other}"));
        assert!(said.contains("2 frames drawn, 0 kept"), "{other}: {said}");
    }
}

#[test]
fn frames_of_a_scene_file_are_kept_until_it_says_something_else_at_their_time() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let scene = path("scene.ron");
    let write = |height: f32, shoulder: f32| {
        let motion = format!(
            "(of: \"spheres[0].centre[1]\", keys: [(0, 0), (2, 0), (3, {height:?}), (4, 0)])"
        );
        let text = format!(
            "(length: 6, film: (shoulder: {shoulder:?}), materials: {{\"a\": (colour: (1, 1, 1))}}, ambient: (1, 1, 1), \
             spheres: [(centre: (0, 0, -3), radius: 1, material: \"a\")], motions: [{motion}])"
        );
        fs::write(&scene, text).unwrap();
    };
    let more = format!("--scene {} --fps 1", scene.display());
    let png = |what: &str| {
        let said = captured("--png", &path("frames"), &more);
        assert!(said.contains(what), "{said}");
    };
    write(1.0, 1.0);
    png("6 frames drawn, 0 kept");
    // Frame 3 alone shows it: neither the first nor the last.
    write(0.5, 1.0);
    png("1 frames drawn, 5 kept");
    write(0.5, 0.5);
    png("6 frames drawn, 0 kept");
}

#[test]
fn three_parts_one_of_them_killed_and_run_again_are_the_whole() {
    let folder = tempfile::tempdir().unwrap();
    let (whole, killed) = (folder.path().join("whole"), folder.path().join("killed"));
    let more = "--to 40 --size 320x240 --quality exhaustive";
    captured("--png", &whole, more);
    let part = |number| format!("{more} --part {number}/3");
    captured("--png", &killed, &part(3));
    let second = part(2);
    let mut capture = command(&line(&format!("--png {} {second}", killed.display())))
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let first = killed.join("frame-000015.png");
    while !first.exists() && capture.try_wait().unwrap().is_none() {
        std::thread::yield_now();
    }
    let _ = capture.kill();
    capture.wait().unwrap();
    for (name, bytes) in files(&killed) {
        if name.starts_with("frame-") {
            assert_eq!(read_png(&bytes).1.len(), 320 * 240, "{name}");
        }
    }
    for number in 1..=3 {
        captured("--png", &killed, &part(number));
    }
    let mut files_then = files(&killed);
    // The name of the incomplete file starts with a dot.
    files_then.retain(|(name, _)| !name.starts_with('.'));
    assert!(files_then == files(&whole));
}
