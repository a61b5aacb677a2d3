//! Frames are blurred by motion, by the lens and by lamps with a size, as much as they should be.

use super::{captured, files};
use crate::lab;
use eightfold_stage::reader::read_png;
use std::fs;

/// A white sphere on black that moves 4 units to the right within a second, seen by a camera 10 units away.
const MOVING: &str = "Scene(
    length: 2.0,
    camera: (eye: (0.0, 0.0, 10.0), look_at: (0.0, 0.0, 0.0), field_of_view: 0.4),
    ambient: (1.0, 1.0, 1.0),
    materials: {\"white\": (colour: (1.0, 1.0, 1.0))},
    spheres: [(centre: (-2.0, 0.0, 0.0), radius: 0.5, material: \"white\")],
    motions: [(of: \"spheres[0].centre\", keys: [(0.0, (-2.0, 0.0, 0.0)), (1.0, (2.0, 0.0, 0.0))])],
)";

/// Small spheres at the distances 5, 10 and 20, below each other.
const DEEP: &str = "Scene(
    camera: (eye: (0.0, 0.0, 10.0), look_at: (0.0, 0.0, 0.0), field_of_view: 0.4),
    ambient: (1.0, 1.0, 1.0),
    materials: {\"white\": (colour: (1.0, 1.0, 1.0))},
    spheres: [
        (centre: (0.0, 0.5, 5.0), radius: 0.1, material: \"white\"),
        (centre: (0.0, 0.0, 0.0), radius: 0.2, material: \"white\"),
        (centre: (0.0, -2.0, -10.0), radius: 0.4, material: \"white\"),
    ],
)";

/// A floor below a box, lit by a lamp with a size.
const SHADOW: &str = "Scene(
    camera: (eye: (0.0, 8.0, 0.1), look_at: (0.0, 0.0, 0.0), field_of_view: 0.6),
    materials: {
        \"white\": (colour: (1.0, 1.0, 1.0), kd: 1.0),
        \"black\": (),
    },
    planes: [(centre: (0.0, 0.0, 0.0), half_x: 9.0, half_z: 9.0, material: \"white\")],
    blocks: [(centre: (-1.0, 1.0, 0.0), half: (1.0, 0.05, 9.0), material: \"black\")],
    lights: [(position: (0.0, 5.0, 0.0), colour: (1.0, 1.0, 1.0), diameter: 1.0)],
)";

/// The brightness of the pixels of the first frame of a scene, row by row, 0 to 255.
fn frame(scene: &str, more: &str) -> Vec<u8> {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("scene.ron");
    fs::write(&file, scene).expect("it is written");
    let frames = folder.path().join("frames");
    let scene = file.display();
    let what = format!("--scene {scene} --size 96x64 --to 1 --fps 1 --quality exhaustive {more}");
    captured("--png", &frames, &what);
    let (_, pixels) = read_png(&files(&frames)[0].1);
    pixels.iter().map(|pixel| *pixel as u8).collect()
}

/// The sum of a row, 0 to 1 for each pixel, and its middle in pixels.
fn row(picture: &[u8], y: usize) -> (f64, f64) {
    let row = picture[y * 96..][..96]
        .iter()
        .map(|&v| f64::from(v) / 255.0);
    let sum: f64 = row.clone().sum();
    let middle: f64 = row.enumerate().map(|(x, v)| x as f64 * v).sum();
    (sum, middle / sum)
}

#[test]
fn what_moves_is_blurred_over_the_time_that_the_shutter_is_open() {
    // At the middle of the picture a unit is as many pixels.
    let unit = 64.0 / (2.0 * 0.2_f64.tan() * 10.0);
    let still = frame(MOVING, "");
    let (sum, start) = row(&still, 32);
    assert!((start - (47.5 - 2.0 * unit)).abs() < 0.5, "{start}");
    for (shutter, moved) in [(0.5, 1.0), (1.0, 2.0)] {
        let blurred = frame(MOVING, &format!("--shutter {shutter} --samples 256"));
        let (total, middle) = row(&blurred, 32);
        // The light is the same, and its middle is where the sphere is in the middle of the time.
        assert!((total / sum - 1.0).abs() < 0.05, "{total}, {sum}");
        let way = middle - start;
        assert!((way - moved * unit).abs() < 0.6, "{way}, {unit}");
        // No point of the way shows it all of the time.
        assert!(blurred.iter().all(|&v| v < 200), "{shutter}");
    }
}

#[test]
fn what_is_in_focus_stays_sharp_and_the_rest_is_blurred_by_the_lens() {
    let rows = |more: &str| {
        let picture = frame(DEEP, more);
        // How many pixels of the three spheres are neither black nor white.
        let of = |rows: std::ops::Range<usize>| {
            let pixels = &picture[rows.start * 96..rows.end * 96];
            pixels.iter().filter(|&&v| v > 25 && v < 230).count()
        };
        [of(0..24), of(24..40), of(40..64)]
    };
    let pinhole = rows("--samples 64");
    for (focus, sharp) in [("", 1), ("--focus 5", 0), ("--focus 20", 2)] {
        let blurred = rows(&format!("--aperture 0.6 {focus} --samples 64"));
        for i in 0..3 {
            let is_right = if i == sharp {
                blurred[i] <= pinhole[i] + 12
            } else {
                blurred[i] > 2 * pinhole[i] + 12
            };
            assert!(is_right, "{focus}: {blurred:?}, {pinhole:?}");
        }
    }
}

#[test]
fn sampled_lamps_give_blocks_the_soft_shadows_of_the_truth() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("shadow.ron");
    fs::write(&file, SHADOW).expect("it is written");
    let output = lab(&format!(
        "truth --scene {} --size 96x64 --without indirect --samples 256 --out -",
        file.display()
    ));
    let (_, truth) = read_png(&output.stdout);
    let truth: Vec<u8> = truth.iter().map(|&pixel| pixel as u8).collect();
    let off = |picture: Vec<u8>| {
        let pairs = picture.iter().zip(&truth);
        let sum: f64 = pairs.map(|(&a, &b)| f64::from(a.abs_diff(b))).sum();
        sum / truth.len() as f64
    };
    let (hard, soft) = (
        off(frame(SHADOW, "--samples 128")),
        off(frame(SHADOW, "--sample-lamps --samples 128")),
    );
    assert!(soft < 1.0 && hard > 4.0 * soft, "{soft}, {hard}");
}

#[test]
fn a_lamp_that_is_drawn_keeps_its_place_while_it_is_sampled() {
    let scene = SHADOW.replace("diameter: 1.0", "diameter: 1.0, drawn_radius: 0.3");
    let rows = |more: &str| {
        let picture = frame(&scene, more);
        let bright = picture.iter().filter(|&&v| v == 255).count();
        (bright, row(&picture, 31).0)
    };
    let (still, sampled) = (rows("--samples 32"), rows("--sample-lamps --samples 32"));
    assert!(
        still.0 > 20 && still.0.abs_diff(sampled.0) * 50 < still.0,
        "{still:?}, {sampled:?}"
    );
    assert!(still.1 != sampled.1);
}

#[test]
fn exposed_frames_are_the_same_in_parts_and_by_any_number_of_threads() {
    let folder = tempfile::tempdir().expect("a folder");
    let name = |name: &str| folder.path().join(name);
    let what = "--shutter 0.5 --aperture 0.1 --focus 7 --sample-lamps --samples 5";
    captured(
        "--png",
        &name("whole"),
        &format!("--from 2 --to 6 {what} --threads 3"),
    );
    for part in ["--from 4 --to 6", "--from 2 --to 4"] {
        captured(
            "--png",
            &name("parts"),
            &format!("{part} {what} --threads 1"),
        );
    }
    let whole = files(&name("whole"));
    assert!(whole.len() == 4 && whole == files(&name("parts")));
    // Each flag makes other frames.
    for other in [
        "--shutter 0.6 --aperture 0.1 --focus 7 --sample-lamps --samples 5",
        "--shutter 0.5 --aperture 0.2 --focus 7 --sample-lamps --samples 5",
        "--shutter 0.5 --aperture 0.1 --sample-lamps --samples 5",
        "--shutter 0.5 --aperture 0.1 --focus 7 --samples 5",
        "--shutter 0.5 --aperture 0.1 --focus 7 --sample-lamps --samples 6",
        "--shutter 0.5",
        "",
    ] {
        let said = captured("--png", &name("parts"), &format!("--from 2 --to 6 {other}"));
        assert!(said.contains("4 frames drawn, 0 kept"), "{other}: {said}");
    }
}
