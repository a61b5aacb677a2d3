//! `--still`: one frame of the very program that plays.

mod stage;

use eightfold::{Band, Level, Memory, Quality, Worker, render, scene::Scene, show};
use eightfold_window::{cpu, fixed::Fixed};
use stage::{headless, intro, run, texts, tool};
use std::process::Command;
use std::sync::{LazyLock, Mutex};

/// The tracer's memory, while it is lent out.
type Lent = (&'static mut Memory, &'static mut [Worker; 1]);

/// A frame that the intro writes, with options: width, height, and red, green and blue of each pixel.
fn still(options: &str) -> (usize, usize, Vec<u8>) {
    let (output, _) = run(headless().args(options.split(' ')));
    let (_, errors) = texts(&output);
    assert!(output.status.success(), "{options}: {errors}");
    assert_eq!(errors, "", "{options}");
    let mut parts = output.stdout.splitn(4, |&byte| byte == b'\n');
    let mut line = || str::from_utf8(parts.next().expect("a line")).expect("text");
    assert_eq!(line(), "P6", "{options}");
    let (width, height) = line().split_once(' ').expect("two numbers");
    let size = |text: &str| text.parse::<usize>().expect("a number");
    let (width, height) = (size(width), size(height));
    assert_eq!(line(), "255", "{options}");
    let pixels = parts.next().expect("pixels").to_vec();
    assert_eq!(pixels.len(), 3 * width * height, "{options}");
    (width, height, pixels)
}

#[test]
fn a_frame_has_the_size_that_is_asked_for() {
    for (options, size) in [
        ("--still 2", (1024, 768)),
        ("--still 0 --size 1x1", (1, 1)),
        ("--size=333x77 --still=90", (333, 77)),
        ("--still .5 --size 3840x2160", (3840, 2160)),
    ] {
        let (width, height, pixels) = still(options);
        assert_eq!((width, height), size, "{options}");
        assert!(
            width < 9 || pixels.iter().any(|&byte| byte > 0),
            "{options}"
        );
    }
}

#[test]
fn any_number_of_threads_writes_the_same_bytes() {
    let one = still("--still 62.3 --size 641x363 --threads 1");
    assert!(one == still("--still 62.3 --size 641x363 --threads 3"));
}

/// The frame of the library that this test is built with.
fn drawn(level: Level, time: f32, quality: &Quality, width: usize, height: usize) -> Vec<u8> {
    static MEMORY: Fixed<Memory> = Fixed::new(Memory::new());
    static WORKERS: Fixed<[Worker; 1]> = Fixed::new([Worker::new()]);
    static LENT: LazyLock<Mutex<Lent>> =
        LazyLock::new(|| Mutex::new((MEMORY.take(), WORKERS.take())));
    let (memory, workers) = &mut *LENT.lock().expect("no panic before");
    let mut scene = Box::new(Scene::ZEROED);
    show::at(time, &mut scene);
    let mut pixels = vec![0; width * height];
    render(
        level,
        &scene,
        quality,
        width,
        height,
        memory,
        &mut workers[..],
        &mut pixels,
        |workers: &mut [Worker], bands: &mut [Band<'_>], job| {
            for band in bands {
                job(&mut workers[0], band);
            }
        },
    );
    let rgb = |pixel: &u32| {
        let [_, red, green, blue] = pixel.to_be_bytes();
        [red, green, blue]
    };
    pixels.iter().flat_map(rgb).collect()
}

#[test]
fn every_instruction_set_and_quality_writes_the_frame_of_the_library() {
    for isa in cpu::instruction_sets() {
        for (name, quality) in [
            ("default", Quality::DEFAULT),
            ("finest", Quality::LADDER[0]),
            ("thesis", Quality::THESIS),
            ("exhaustive", Quality::EXHAUSTIVE),
        ] {
            let options = format!(
                "--still 33.7 --size 320x200 --isa {} --quality {name}",
                isa.name
            );
            let (width, height, pixels) = still(&options);
            let drawn = drawn(isa.level, 33.7, &quality, width, height);
            assert!(pixels == drawn, "{options}");
        }
    }
    let exhaustive = still("--still 33.7 --size 320x200 --quality exhaustive");
    assert!(exhaustive == still("--still 33.7 --size 320x200 --exhaustive"));
    let default = still("--still 33.7 --size 320x200 --quality default");
    assert!(default == still("--still 33.7 --size 320x200"));
}

#[test]
fn what_can_not_be_written_is_an_error_in_one_line() {
    for (output, expected) in [
        ("> /dev/full", 1),
        (">&-", 1),
        // A pipe that nobody reads from, and one that is closed in the middle of the frame.
        ("| true", 1),
        ("| head -c 1000 > /dev/null", 1),
    ] {
        let script = format!(
            "{} --silent --still 2 {output}; exit ${{PIPESTATUS[0]}}",
            intro().display()
        );
        let (output, _) = run(Command::new("bash").args(["-c", &script]));
        let (_, errors) = texts(&output);
        assert_eq!(output.status.code(), Some(expected), "{script}: {errors}");
        let line = "eightfold: can't write to standard output\n";
        assert_eq!(errors, line, "{script}");
    }
}

#[test]
fn a_terminal_is_refused() {
    if stage::lacks(&["script"]) {
        return;
    }
    let command = format!("{} --still 2; echo code $?", intro().display());
    let (_, said) = run(tool("script").args(["-q", "-c", &command, "/dev/null"]));
    let lines: Vec<&str> = said.lines().map(str::trim_end).collect();
    let [error, code] = lines[..] else {
        panic!("{said}");
    };
    assert!(
        error.starts_with("eightfold: a terminal can't show"),
        "{said}"
    );
    assert_eq!(code, "code 2");
}
