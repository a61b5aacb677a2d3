//! The lab's commands, run from the command line.

mod bad_input;
mod bench;
mod capture;
mod figures;
mod ladder;
mod missed;
mod parts;
mod report;
mod sampler;
mod scene;
mod size;
mod sound;
mod trade;
mod truth;
mod views;

use eightfold_stage::{reader::read_png, texts};
use std::path::Path;
#[cfg(target_os = "linux")]
use std::process::Child;
use std::process::{Command, Output};

/// The lab with the words of a line, of which `""` is an empty one.
fn command(line: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lab"));
    command.args(line.split_whitespace().map(|word| word.trim_matches('"')));
    command
}

/// Runs the lab with the words of a line.
fn lab(line: &str) -> Output {
    command(line).output().expect("the lab starts")
}

/// The text that a command prints on standard error.
fn said(output: &Output) -> String {
    texts(output).1
}

/// The text that the lab prints on standard output, for the words of a line, without an error.
#[track_caller]
fn printed(line: &str) -> String {
    let output = lab(line);
    assert!(output.status.success(), "{line}: {}", said(&output));
    String::from_utf8(output.stdout).expect("text")
}

/// The cells of the tables in a text, line by line, without the rules under the titles.
fn cells(text: &str) -> Vec<Vec<&str>> {
    let lines = text.lines();
    let lines = lines.filter(|line| line.starts_with('|') && !line.starts_with("| -"));
    lines
        .map(|line| line.trim_matches('|').split('|').map(str::trim).collect())
        .collect()
}

/// Runs `lab render` with a small frame.
fn render(out: &Path, more: &str) -> Output {
    lab(&format!(
        "render --size 40x30 --out {} {more}",
        out.display()
    ))
}

/// Asserts that a command failed with an exit code, and printed one line that contains some words, and no temporary name.
#[track_caller]
fn assert_one_line(output: &Output, code: i32, words: &[&str]) {
    let text = said(output);
    assert_eq!(output.status.code(), Some(code), "{text}");
    assert_eq!(text.trim_end().lines().count(), 1, "{text}");
    assert!(!text.contains(".lab-"), "{text}");
    for word in words {
        assert!(text.contains(word), "no {word} in: {text}");
    }
    assert!(output.stdout.is_empty());
}

#[test]
fn a_frame_is_written_whole() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("frame.png");
    let output = render(&file, "");
    let said = said(&output);
    assert!(
        output.status.success() && output.stdout.is_empty(),
        "{said}"
    );
    assert!(
        said.starts_with("wrote ") && said.contains("frame.png, in "),
        "{said}"
    );
    let (width, pixels) = read_png(&std::fs::read(&file).unwrap());
    assert_eq!((width, pixels.len()), (40, 40 * 30));
    let black = pixels.iter().filter(|&&pixel| pixel == 0).count();
    assert_eq!(black, 0, "the background alone is brighter than that");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn a_file_is_called_as_it_was_asked_for_whether_it_is_there_or_not() {
    let folder = tempfile::tempdir().unwrap();
    for _ in 0..2 {
        let mut render = command("render --size 40x30 --out x.png");
        let said = said(&render.current_dir(folder.path()).output().unwrap());
        assert!(said.starts_with("wrote x.png, in "), "{said}");
    }
}

/// Starts the lab, and waits until it has said what is to be done on a signal.
#[cfg(target_os = "linux")]
fn start(command: &mut Command) -> Child {
    use std::process::Stdio;
    let command = command.stdout(Stdio::piped()).stderr(Stdio::piped());
    let child = command.spawn().expect("the lab starts");
    let status = format!("/proc/{}/status", child.id());
    eightfold_stage::wait_for("the signals to be heard", || {
        let status = std::fs::read_to_string(&status).expect("it runs");
        let (_, heard) = status.split_once("SigCgt:").expect("a set of signals");
        let heard = heard.split_whitespace().next().expect("a number");
        let heard = u64::from_str_radix(heard, 16).expect("hexadecimal digits");
        // Bit 0 is that of signal 1.
        (heard >> (2 - 1) & 1 != 0).then_some(())
    });
    child
}

/// Sends a signal to a process, or to a group of them by the number of its first one with a minus.
#[cfg(target_os = "linux")]
fn signal(process: &str, name: &str) -> bool {
    let kill = format!("kill -s {name} -- {process}");
    let mut sh = Command::new("sh");
    let status = sh.args(["-c", &kill]).stderr(std::process::Stdio::null());
    status.status().unwrap().success()
}

#[cfg(target_os = "linux")]
#[test]
fn commands_without_results_so_far_end_on_a_signal_with_one_line() {
    let folder = tempfile::tempdir().unwrap();
    for line in [
        "render --size 3840x2160 --quality exhaustive --threads 1 --out x.png",
        "figures --size 3840x2160 --quality exhaustive --out figures",
        "sound --wav x.wav --spectrogram x.png",
        "scene --export show --fps 1000 --out x.ron",
    ] {
        let child = start(command(line).current_dir(folder.path()));
        assert!(signal(&child.id().to_string(), "INT"), "{line}");
        let output = child.wait_with_output().unwrap();
        assert_one_line(&output, 130, &["stopped at once"]);
    }
    let left = std::fs::read_dir(folder.path()).unwrap();
    let left: Vec<_> = left.map(|entry| entry.unwrap().file_name()).collect();
    assert!(left.iter().all(|name| name == "figures"), "{left:?}");
}

#[test]
fn standard_output_gets_the_same_bytes_as_a_file() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("frame.png");
    render(&file, "--time 3.5 --threads 1");
    let output = render(Path::new("-"), "--time 3.5 --threads 3");
    assert!(output.status.success() && output.stderr.is_empty());
    assert_eq!(output.stdout, std::fs::read(&file).unwrap());
}

#[test]
fn every_choice_changes_the_picture() {
    let picture = |more: &str| {
        let output = lab(&format!("render --out - {more}"));
        assert!(output.status.success(), "{more}");
        output.stdout
    };
    let plain = picture("--size 40x30");
    for more in [
        "--size 40x30 --quality exhaustive",
        "--size 40x30 --time -1",
        "--size 40x30 --scene field:20",
        "--size 40x30 --scene show:finale",
        "--size 40x30 --jagged",
        "--size 41x30",
    ] {
        assert_ne!(picture(more), plain, "{more}");
    }
    assert_eq!(picture("--size 40x30 --scene model --time 0"), plain);
}

#[test]
fn a_file_that_cannot_be_written_is_named_in_one_line() {
    let folder = tempfile::tempdir().unwrap();
    let no_folder = folder.path().join("missing/frame.png");
    assert_one_line(&render(&no_folder, ""), 1, &["missing/frame.png"]);
    assert_one_line(&render(folder.path(), ""), 1, &["cannot write"]);
    assert_one_line(&render(Path::new(".."), ""), 1, &["cannot write"]);
    let long = folder.path().join("x".repeat(300));
    assert_one_line(&render(&long, ""), 1, &["cannot write"]);
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn a_closed_standard_output_is_named_in_one_line() {
    for command in [
        "render --size 40x30 --out -",
        "--help",
        "bench --help",
        "--version",
    ] {
        let output = Command::new("sh")
            .args(["-c", "exec \"$0\" \"$@\" >&-"])
            .arg(env!("CARGO_BIN_EXE_lab"))
            .args(command.split(' '))
            .output()
            .unwrap();
        assert_one_line(&output, 1, &["standard output"]);
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_named_in_one_line() {
    let output = render(Path::new("/dev/full"), "");
    assert_one_line(&output, 1, &["/dev/full", "No space left"]);
}

/// Runs the lab with the words of a line, and with files limited to 1 KiB. The signal for exceeding the limit is ignored.
fn limited(line: &str) -> Output {
    let mut sh = Command::new("bash");
    sh.args(["-c", "trap '' XFSZ; ulimit -f 1; exec \"$0\" \"$@\""])
        .arg(env!("CARGO_BIN_EXE_lab"))
        .args(line.split_whitespace());
    sh.output().expect("bash runs")
}

#[cfg(target_os = "linux")]
#[test]
fn a_file_stays_as_it_was_when_the_disk_fills_up() {
    use std::os::unix::fs::FileTypeExt;
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("frame.png");
    std::fs::write(&file, "before").unwrap();
    let output = limited(&format!("render --size 640x480 --out {}", file.display()));
    assert_one_line(&output, 1, &["frame.png"]);
    assert_eq!(std::fs::read(&file).unwrap(), b"before");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    let full = std::fs::metadata("/dev/full").unwrap();
    assert!(full.file_type().is_char_device(), "a device stays one");
}

#[test]
fn help_names_the_commands_that_the_page_lists_and_no_others() {
    let page = include_str!("../../../../docs/lab.md");
    let (_, table) = page.split_once("| command | does |").expect("a table");
    let table = table.split("\n\n").next().expect("its lines");
    let listed = cells(table)
        .into_iter()
        .map(|line| line[0].trim_matches('`'));
    let mut listed: Vec<&str> = listed.collect();
    listed.sort_unstable();
    let help = printed("--help");
    let (_, commands) = help.split_once("Commands:\n").expect("commands");
    let commands = commands.lines().take_while(|line| !line.is_empty());
    let names = commands.filter_map(|line| line.split_whitespace().next());
    let names: Vec<&str> = names.filter(|&name| name != "help").collect();
    assert_eq!(names, listed);
    for name in names {
        assert!(
            printed(&format!("{name} --help")).contains("Usage: "),
            "{name}"
        );
    }
}
