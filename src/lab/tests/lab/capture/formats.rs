//! The contents of captured files: pictures, videos and sheets.

use super::{captured, files};
use crate::lab;
use eightfold::show;
use eightfold_lab::error::{Difference, worst_channel};
use eightfold_stage::{needs, reader::read_png, run, tool};
use std::fs;
use std::ops::Range;

/// The pixels of a file of red, green and blue bytes.
fn pixels(rgb: &[u8]) -> Vec<u32> {
    let pixel = |c: &[u8]| u32::from_be_bytes([0, c[0], c[1], c[2]]);
    rgb.chunks_exact(3).map(pixel).collect()
}

/// The same frames, drawn by `lab render`.
fn rendered(times: &[&str], size: &str) -> Vec<u32> {
    let picture = |time: &&str| {
        let output = lab(&format!("render --size {size} --time {time} --out -"));
        read_png(&output.stdout).1
    };
    times.iter().flat_map(picture).collect()
}

#[test]
fn frames_are_the_pictures_of_their_times() {
    let folder = tempfile::tempdir().unwrap();
    captured("--png", folder.path(), "--fps 4 --from 10 --to 12");
    let frames: Vec<u32> = files(folder.path())
        .iter()
        .flat_map(|(_, bytes)| read_png(bytes).1)
        .collect();
    assert!(frames == rendered(&["2.5", "2.75"], "48x32"));
}

#[test]
fn without_a_range_it_is_the_whole_show() {
    for (scene, seconds) in [
        ("show", show::LENGTH),
        ("show:machine", 12.0),
        ("model", show::MODEL_LENGTH.ceil()),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let more = format!("--scene {scene} --fps 1 --size 8x8");
        captured("--png", folder.path(), &more);
        assert_eq!(files(folder.path()).len(), seconds as usize);
        // An end beyond the scene's end stands for that.
        let said = captured("--png", folder.path(), &format!("{more} --to 99999"));
        let kept = format!("0 frames drawn, {seconds} kept");
        assert!(said.contains(&kept), "{said}");
    }
}

#[test]
fn it_is_the_show_unless_asked_otherwise() {
    // Without AVX2 the instruction set has to be named, which another test checks.
    #[cfg(target_arch = "x86_64")]
    if !is_x86_feature_detected!("avx2") {
        return;
    }
    let captured = |more: &str| {
        let one = "capture --sheet - --size 48x32 --fps 1 --from 20 --to 21 --frames 1";
        lab(&format!("{one} {more}")).stdout
    };
    let show = captured("");
    assert!(!show.is_empty() && show == captured("--scene show"));
    assert!(show != captured("--scene model"));
}

#[test]
fn a_video_has_all_frames_and_their_colours() {
    needs!(&["ffmpeg"]);
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    for name in ["show.mp4", "show.mkv"] {
        tool("ffmpeg");
        captured("--video", &path(name), "--fps 4 --to 3 --size 480x360");
        let mut ffmpeg = tool("ffmpeg");
        let (output, _) = run(ffmpeg
            .args(["-v", "error", "-i"])
            .arg(path(name))
            .args(["-f", "rawvideo", "-pix_fmt", "rgb24", "-"]));
        let decoded = pixels(&output.stdout);
        let wanted = rendered(&["0", "0.25", "0.5"], "480x360");
        assert_eq!(decoded.len(), wanted.len(), "{name}");
        // With 4:2:0 the difference is 1.2. With the wrong matrix it is 2.2.
        let difference = Difference::between(&decoded, &wanted).mean;
        assert!(difference < 1.6, "{name}: {difference}");
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
}

#[test]
fn a_supersampled_pixel_is_the_mean_of_its_parts() {
    let folder = tempfile::tempdir().unwrap();
    let more = "--to 1 --quality exhaustive --supersample 2";
    captured("--png", folder.path(), more);
    let (_, bytes) = &files(folder.path())[0];
    let (_, mean) = read_png(bytes);
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
    // Rays that graze an edge may hit or miss it, depending on rounding.
    assert!(far.count() <= 2);
}

#[test]
fn a_sheet_shows_frames_spread_evenly() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("sheet.png");
    let more = "--frames 6 --fps 4 --from 8 --to 32 --size 48x32";
    let said = captured("--sheet", &file, more);
    assert!(
        said.contains("frames 10 14 18 22 26 30, row by row"),
        "{said}"
    );
    let (width, sheet) = read_png(&fs::read(&file).unwrap());
    let (columns, gap, caption) = (3, 8, 18);
    assert_eq!(width, gap + columns * (48 + gap));
    assert_eq!(sheet.len() / width, gap + 2 * (32 + caption + gap));
    let mut captions = Vec::new();
    for (i, time) in ["2.5", "3.5", "4.5", "5.5", "6.5", "7.5"]
        .iter()
        .enumerate()
    {
        let (left, top) = (
            gap + i % columns * (48 + gap),
            gap + i / columns * (32 + caption + gap),
        );
        let rows = |rows: Range<usize>| {
            let rows = rows.map(|y| &sheet[y * width + left..][..48]);
            rows.collect::<Vec<_>>().concat()
        };
        assert!(rows(top..top + 32) == rendered(&[time], "48x32"), "{i}");
        let caption = rows(top + 32..top + 32 + caption);
        let bright = caption.iter().filter(|&&pixel| pixel > 0x00a0_a0a0);
        assert!(bright.count() > 20, "text is under frame {i}");
        captions.push(caption);
    }
    // Each strip shows another time, at the same height.
    captions.sort();
    captions.dedup();
    assert_eq!(captions.len(), 6);
    // The default is 24 frames of 320 by 240.
    let (width, sheet) = read_png(&lab("capture --sheet -").stdout);
    assert_eq!((width, sheet.len() / width), (8 + 6 * 328, 8 + 4 * 266));
}
