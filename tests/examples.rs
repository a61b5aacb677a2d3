//! The examples: each is built, runs, and draws what it says.

use eightfold_lab::cargo::Build;
use eightfold_stage::{DISPLAY, Server, lacks, reader::read_png, run, texts, wait_for};
use std::{
    collections::BTreeSet,
    fs,
    path::{Path, PathBuf},
    process::Command,
    sync::LazyLock,
};

/// The program of an example.
fn example(name: &str) -> Command {
    static BUILD: LazyLock<Build> =
        LazyLock::new(|| Build::release("eightfold-examples").expect("they can be built"));
    Command::new(BUILD.program(name).expect("there is one"))
}

/// The program of the example that is a crate of its own.
fn window() -> Command {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let target = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("window");
    let output = Command::new(env!("CARGO"))
        .args(["build", "--release", "--locked"])
        .current_dir(root.join("examples/window"))
        .env("CARGO_TARGET_DIR", &target)
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "{}", texts(&output).1);
    Command::new(target.join("release/window"))
}

/// The picture that an example draws to a file, whose pixels are `0x00RRGGBB`, and what the example says.
fn picture(name: &str) -> (Vec<u32>, String) {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("picture.png");
    let (output, text) = run(example(name).arg(&file));
    assert!(output.status.success(), "{}", texts(&output).1);
    let (width, pixels) = read_png(&fs::read(file).expect("a file"));
    assert_eq!((width, pixels.len()), (640, 640 * 360));
    (pixels, text)
}

/// The channels of a pixel.
fn channels(pixel: u32) -> [u8; 3] {
    let [_, red, green, blue] = pixel.to_be_bytes();
    [red, green, blue]
}

#[test]
#[ignore = "examples are compiled"]
fn they_need_the_library_a_window_and_png_files_alone() {
    let (output, tree) = run(Command::new(env!("CARGO"))
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .args(["tree", "--package", "eightfold-examples", "--offline"])
        .args(["--prefix", "none", "--no-dedupe"]));
    assert!(output.status.success(), "{}", texts(&output).1);
    let crates: BTreeSet<&str> = tree
        .lines()
        .filter_map(|line| line.split(' ').next())
        .collect();
    assert!(crates.contains("eightfold-tracer"), "{tree}");
    for needless in ["eightfold-lab", "eightfold-pack", "eightfold-stage"] {
        assert!(!crates.contains(needless), "{tree}");
    }
    assert!(crates.len() < 25, "{} crates: {tree}", crates.len());
}

#[test]
#[ignore = "examples are compiled"]
fn still_draws_a_red_and_a_clear_sphere_under_a_blue_sky() {
    let (pixels, text) = picture("still");
    assert!(text.starts_with("230400 pixels by "), "{text}");
    let [red, _, blue] = channels(pixels[20 * 640 + 320]);
    assert!(blue > red + 20, "the sky");
    let [red, green, blue] = channels(pixels[180 * 640 + 395]);
    assert!(red > 2 * green.max(blue), "the red sphere");
    let [red, green, blue] = channels(pixels[180 * 640 + 240]);
    assert!(red.min(green).min(blue) > 60, "the clear sphere");
}

#[test]
#[ignore = "examples are compiled"]
fn squares_draws_lines_over_less_than_half_of_the_picture() {
    let (pixels, text) = picture("squares");
    let count: usize = text
        .trim_end_matches(" squares\n")
        .parse()
        .expect("a number");
    assert!((3600..20_000).contains(&count), "{count} squares");
    // The sky is of one colour, and its squares are of 8 pixels.
    let sky = pixels[640 + 1];
    for (x, y) in [(8, 1), (1, 8), (8, 8), (16, 3)] {
        assert!(pixels[y * 640 + x] > sky, "no line at {x}, {y}");
    }
    for (x, y) in [(7, 1), (9, 9), (15, 7)] {
        assert_eq!(pixels[y * 640 + x], sky, "a line at {x}, {y}");
    }
}

#[test]
#[ignore = "examples are compiled"]
fn trade_tells_speed_and_error_of_each_rung() {
    let (output, text) = run(&mut example("trade"));
    assert!(output.status.success(), "{}", texts(&output).1);
    let rows: Vec<Vec<&str>> = text
        .lines()
        .skip(1)
        .map(|row| row.split_whitespace().collect())
        .collect();
    let names: Vec<&str> = rows.iter().map(|row| row[0]).collect();
    assert_eq!(names, eightfold_tracer::Quality::NAMES);
    let psnr = |row: &Vec<&str>| row[3].parse::<f64>().expect("a number");
    assert!(rows.iter().all(|row| psnr(row) > 35.0), "{text}");
    assert!(
        rows.is_sorted_by(|finer, faster| psnr(finer) >= psnr(faster)),
        "{text}"
    );
}

/// Opens an example's window, which has to show many colours and to end by Esc.
fn assert_shows(program: &mut Command, name: &str) {
    let server = Server::start(1280, 800);
    let program = server.open(program, || server.geometry(&["-name", name]));
    let place = server.geometry(&["-name", name]).expect("a window");
    wait_for("a picture", || {
        let colours: BTreeSet<u32> = server.screenshot(place).into_iter().collect();
        (colours.len() > 500).then_some(())
    });
    let [x, y, ..] = place;
    server.xdotool(&format!("mousemove {} {}", x + 20, y + 20));
    // One that is released before the program looks at its keys is not seen by minifb.
    wait_for("the end", || {
        server.xdotool("keydown Escape sleep 0.1 keyup Escape");
        server.geometry(&["-name", name]).is_none().then_some(())
    });
    let (_, code, _, errors) = program.end();
    assert_eq!(code, Some(0), "{errors}");
}

#[test]
#[ignore = "examples are compiled"]
fn intro_shows_a_picture_until_esc() {
    if !lacks(DISPLAY) {
        assert_shows(&mut example("intro"), "Ten seconds");
    }
}

#[test]
#[ignore = "examples are compiled"]
fn intro_without_a_display_says_so_in_one_line() {
    let (output, _) = run(example("intro").env_remove("DISPLAY"));
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(texts(&output).1, "Error: \"no X display\"\n");
}

#[test]
#[ignore = "the libraries of minifb are compiled"]
fn window_is_a_crate_of_its_own_that_shows_a_picture_until_esc() {
    if !lacks(DISPLAY) {
        assert_shows(&mut window(), "Ring");
    }
}
