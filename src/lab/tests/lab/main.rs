mod bad_input;
mod bench;
mod capture;
mod figures;
mod report;
mod resources;
mod scene;
#[cfg(target_arch = "x86_64")]
mod size;
mod trade;
mod truth;
mod view_errors;

use eightfold_stage::{reader::read_png, texts};
use std::path::Path;
use std::process::{Command, Output, Stdio};

/// `""` is an empty argument.
fn command(line: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lab"));
    command.args(line.split_whitespace().map(|word| word.trim_matches('"')));
    command
}

fn lab(line: &str) -> Output {
    command(line).output().expect("the lab starts")
}

fn stderr(output: &Output) -> String {
    texts(output).1
}

#[track_caller]
fn printed(line: &str) -> String {
    String::from_utf8(printed_bytes(line)).expect("text")
}

/// Returns the width and the pixels of a printed PNG file.
#[track_caller]
fn picture(line: &str) -> (usize, Vec<u32>) {
    read_png(&printed_bytes(line))
}

#[track_caller]
fn printed_bytes(line: &str) -> Vec<u8> {
    let output = lab(line);
    assert!(output.status.success(), "{line}: {}", stderr(&output));
    output.stdout
}

/// Returns table cells by line, without separators.
fn cells(text: &str) -> Vec<Vec<&str>> {
    let lines = text.lines();
    let lines = lines.filter(|line| line.starts_with('|') && !line.starts_with("| -"));
    lines.map(|line| line.trim_matches('|').split('|').map(str::trim).collect()).collect()
}

fn render(out: &Path, more: &str) -> Output {
    lab(&format!("render --size 40x30 --out {} {more}", out.display()))
}

/// Asserts an exit code and one line with these words, naming no temporary file.
#[track_caller]
fn assert_one_line(output: &Output, code: i32, words: &[&str]) {
    let text = stderr(output);
    assert_eq!(output.status.code(), Some(code), "{text}");
    assert_eq!(text.trim_end().lines().count(), 1, "{text}");
    assert!(text.chars().count() <= 201, "{text}");
    assert!(!text.trim_end().contains(char::is_control), "{text:?}");
    assert!(!text.contains(".lab-"), "{text}");
    for word in words {
        assert!(text.contains(word), "no {word} in: {text}");
    }
    assert!(output.stdout.is_empty());
}

fn signal(process: &str, name: &str) -> bool {
    let kill = format!("kill -s {name} {process}");
    let mut sh = Command::new("sh");
    let status = sh.args(["-c", &kill]).stderr(Stdio::null()).status();
    status.unwrap().success()
}

fn signalled(command: &mut Command, name: &str, number: u32) -> Output {
    let command = command.stdout(Stdio::piped()).stderr(Stdio::piped());
    let child = command.spawn().expect("the lab starts");
    let status = format!("/proc/{}/status", child.id());
    eightfold_stage::wait_for("a handler of the signal", || {
        let status = std::fs::read_to_string(&status).expect("it runs");
        let (_, caught) = status.split_once("SigCgt:").expect("a set of signals");
        let caught = caught.split_whitespace().next().expect("a number");
        let caught = u64::from_str_radix(caught, 16).expect("hexadecimal digits");
        (caught >> (number - 1) & 1 != 0).then_some(())
    });
    assert!(signal(&child.id().to_string(), name));
    child.wait_with_output().unwrap()
}

#[test]
fn file_and_standard_output_are_equal() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("frame.png");
    let output = render(&file, "--time 3.5 --threads 1");
    assert!(output.status.success() && output.stdout.is_empty() && output.stderr.is_empty());
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    let output = render(Path::new("-"), "--time 3.5 --threads 3");
    assert!(output.status.success() && output.stderr.is_empty());
    assert_eq!(output.stdout, std::fs::read(&file).unwrap());
    let (width, pixels) = read_png(&output.stdout);
    assert_eq!((width, pixels.len()), (40, 40 * 30));
}

#[test]
fn every_flag_changes_picture() {
    let picture = |more: &str| printed_bytes(&format!("render --size 40x30 --out - {more}"));
    let plain = picture("");
    let flags = "--quality exhaustive|--time -1|--scene field:20|--scene show:finale|--jagged";
    for more in flags.split('|') {
        assert_ne!(picture(more), plain, "{more}");
    }
    assert_eq!(picture("--scene model --time 0"), plain);
}

#[test]
fn full_disk_keeps_old_file() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("frame.png");
    std::fs::write(&file, "before").unwrap();
    // Limit files to 1 KiB, without the signal.
    let limited = "trap '' XFSZ; ulimit -f 1; exec \"$0\" render --size 640x480 --out \"$1\"";
    let mut bash = Command::new("bash");
    let bash = bash.args(["-c", limited, env!("CARGO_BIN_EXE_lab")]);
    assert_one_line(&bash.arg(&file).output().unwrap(), 1, &["frame.png"]);
    assert_eq!(std::fs::read(&file).unwrap(), b"before");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    let output = render(Path::new("/dev/full"), "");
    assert_one_line(&output, 1, &["/dev/full", "No space left"]);
}
