//! The ways in which it ends.

use crate::stage::{FileView, View};
use eightfold_stage::{Process, run};
use std::io;
use std::process::Command;

/// Asserts that it ends with an exit code. Returns its errors.
#[track_caller]
fn assert_ends(process: Process, code: i32) -> String {
    let (_, ended, _, errors) = process.end();
    assert_eq!(ended, Some(code), "{errors}");
    errors
}

#[test]
fn escape_ends_it() {
    let Some(view) = FileView::new() else { return };
    view.view.key("Escape");
    let errors = assert_ends(view.view.process, 0);
    assert_eq!(errors, "view: the key ? lists the keys\n");
    // It leaves no file behind.
    let files = std::fs::read_dir(view.folder.path()).expect("a folder");
    assert_eq!(files.count(), 1);
}

#[test]
fn closed_window_ends_it() {
    let Some(view) = View::new("") else { return };
    view.server.xdotool(&format!("windowclose {}", view.id()));
    assert_ends(view.process, 0);
}

#[test]
fn lost_server_is_an_error() {
    let Some(mut view) = View::new("") else {
        return;
    };
    view.server.kill();
    assert_ends(view.process, 1);
}

#[test]
fn closed_pipe_is_an_error() {
    let Some(mut view) = View::new("") else {
        return;
    };
    drop(view.process.0.stdout.take());
    let pipe = view.process.0.stderr.take().expect("a pipe");
    view.key("c");
    assert_ends(view.process, 1);
    let errors = io::read_to_string(pipe).expect("text");
    assert!(
        errors.contains("cannot write to standard output"),
        "{errors}"
    );
}

#[test]
fn missing_display_is_named_in_one_line() {
    let mut lab = Command::new(env!("CARGO_BIN_EXE_lab"));
    let (output, _) = run(lab.arg("view").env_remove("DISPLAY"));
    let errors = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{errors}");
    assert_eq!(errors.lines().count(), 1, "{errors}");
    assert!(
        errors.contains("view") && errors.contains("no X display"),
        "{errors}"
    );
}
