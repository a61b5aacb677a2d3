use super::{assert_one_line, command, stderr};
use eightfold_lab::progress::Progress;
use std::fs::File;
use std::process::{Command, Output};
use std::time::{Duration, Instant};

/// Runs the lab under a shell's limit.
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
    assert_one_line(
        &output,
        1,
        &["standard output: cannot write: No space left"],
    );
}

#[test]
fn small_stack_fails_in_one_line() {
    let output = limited("-s 96", "render --out -");
    assert_one_line(
        &output,
        1,
        &["stack limit in kB is 96; must be 1024 or more"],
    );
}

#[test]
fn refused_threads_fail_in_one_line() {
    // The stack of a thread has 8 MiB.
    let output = limited(
        "-s 8192 -v 1000000",
        "render --size 8x8 --threads 256 --out -",
    );
    assert_one_line(&output, 1, &["number of started threads is "]);
}

#[test]
fn missing_memory_fails_in_one_line() {
    let mut failed = 0;
    for kilobytes in (60_000..240_000).step_by(20_000) {
        let line = "render --size 3840x2160 --threads 1 --out -";
        let output = limited(&format!("-v {kilobytes}"), line);
        if !output.status.success() {
            failed += 1;
            assert_one_line(&output, 1, &["memory"]);
        }
        assert!(!stderr(&output).contains("backtrace"));
    }
    assert!(failed > 0, "no limit is low enough");
}

#[test]
fn progress_has_line_every_ten_seconds_in_a_log() {
    let start = Instant::now();
    let lines = |is_terminal, milliseconds: [u64; 4]| {
        let progress = Progress::new(20, is_terminal, start);
        milliseconds.map(|at| progress.after(5, start + Duration::from_millis(at)))
    };
    let line = |text: &str| Some(text.to_owned());
    let [half, all] = ["50 %, 10 s to go", "100 %, 0 s to go"].map(line);
    let expected = [None, half, None, all];
    assert_eq!(lines(false, [9_000, 10_000, 11_000, 20_000]), expected);
    let [most, all] = ["75 %, 0 s to go", "100 %, 0 s to go"].map(line);
    assert_eq!(lines(true, [50, 99, 100, 200]), [None, None, most, all]);
}
