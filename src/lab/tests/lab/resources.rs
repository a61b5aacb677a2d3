use super::{assert_one_line, command};
use eightfold_lab::progress::Progress;
use std::fs::File;
use std::process::{Command, Output};
use std::time::Duration;

fn limited(limit: &str, line: &str) -> Output {
    let script = format!("ulimit {limit}; exec \"$0\" {line}");
    let mut bash = Command::new("bash");
    let bash = bash.args(["-c", &script, env!("CARGO_BIN_EXE_lab")]);
    bash.env("RUST_BACKTRACE", "1").output().expect("bash runs")
}

#[test]
fn full_device_fails_help() {
    let full = File::create("/dev/full").expect("a device");
    let output = command("--help").stdout(full).output().expect("it starts");
    assert_one_line(&output, 1, &["standard output: cannot write: No space left"]);
}

#[test]
fn small_stack_fails_in_one_line() {
    let output = limited("-s 96", "render --out -");
    assert_one_line(&output, 1, &["stack limit in kB is 96; must be 1024 or more"]);
}

#[test]
fn refused_threads_fail_in_one_line() {
    // The stack of a thread has 8 MiB.
    let output = limited("-s 8192 -v 1000000", "render --size 8x8 --threads 256 --out -");
    assert_one_line(&output, 1, &["number of started threads is "]);
}

#[test]
fn missing_memory_fails_in_one_line() {
    // Three places that need memory.
    for kilobytes in [30_000, 50_000, 65_000] {
        let line = "render --size 3840x2160 --threads 1 --out -";
        let output = limited(&format!("-v {kilobytes}"), line);
        assert_one_line(&output, 1, &["memory"]);
    }
}

#[test]
fn progress_is_a_line_per_10_s() {
    let progress = Progress::new(10);
    progress.inc(5);
    let after = |seconds| progress.due(progress.start + Duration::from_secs(seconds));
    let lines = [9, 10, 11, 20].map(after);
    let line = |left: &str| Some(format!("50 %, {left} s to go"));
    assert_eq!(lines, [None, line("10"), None, line("20")]);
}
