//! `--still` writes one frame of the show. `tests/image/shipped.rs` compares such frames with the library's and the oracle's.

use eightfold_stage::{headless, intro, needs, reader::read_ppm, run, texts, tool};
use std::{env, process::Command};

/// The frame that the intro writes with some options: its width and its pixels.
fn still(options: &str) -> (usize, Vec<u32>) {
    let (output, _) = run(&mut headless(options));
    let (_, errors) = texts(&output);
    assert!(output.status.success(), "{options}: {errors}");
    assert_eq!(errors, "", "{options}");
    read_ppm(&output.stdout)
}

#[test]
fn a_frame_has_the_size_that_is_asked_for() {
    for (options, size) in [
        ("--still 2", (1024, 768)),
        ("--still 0 --size 1x1", (1, 1)),
        ("--size=333x77 --still=90", (333, 77)),
        ("--still .5 --size 3840x2160", (3840, 2160)),
    ] {
        let (width, pixels) = still(options);
        assert_eq!((width, pixels.len() / width), size, "{options}");
        assert!(
            width < 9 || pixels.iter().any(|&pixel| pixel > 0),
            "{options}"
        );
    }
}

#[test]
fn any_number_of_threads_writes_the_same_bytes() {
    let one = still("--still 62.3 --size 641x363 --threads 1");
    assert!(one == still("--still 62.3 --size 641x363 --threads 3"));
}

#[test]
fn exhaustive_and_default_are_known_by_two_names() {
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
        // A pipe without a reader, and one that is closed in the middle of the frame.
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
    needs!(&["script"]);
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

#[test]
fn a_tool_that_is_missing_is_named() {
    let nothing = tempfile::tempdir().unwrap();
    let mut test = Command::new(env::current_exe().expect("this program"));
    let test = test.args(["--exact", "still::a_terminal_is_refused", "--nocapture"]);
    let (output, _) = run(test
        .env("PATH", nothing.path())
        .env_remove("EIGHTFOLD_TOOLS"));
    let (said, errors) = texts(&output);
    assert!(output.status.success(), "{said}{errors}");
    assert!(errors.contains("not run, needs script"), "{errors}");
}
