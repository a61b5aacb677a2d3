use crate::display::View;
use eightfold_stage::run;
use std::fs;
use std::process::Command;

const HINT: &str = "view: the key ? lists the keys\n";

#[test]
fn escape_ends_the_viewer() {
    let Some(view) = View::of_file() else { return };
    view.key("Escape");
    let (_, code, output, errors) = view.process.end();
    assert_eq!((code, &*output, &*errors), (Some(0), "", HINT));
    let files = fs::read_dir(view.folder.path()).expect("a folder");
    assert_eq!(files.count(), 1);
}

#[test]
fn lost_server_is_reported_by_the_viewer() {
    let Some(mut view) = View::new() else { return };
    view.server.kill();
    let (_, code, _, errors) = view.process.end();
    assert_eq!(code, Some(1), "{errors}");
    assert!(errors.ends_with("display is lost\n"), "{errors}");
}

#[test]
fn missing_display_is_reported_in_one_line() {
    let mut lab = Command::new(env!("CARGO_BIN_EXE_lab"));
    let (output, _) = run(lab.arg("view").env_remove("DISPLAY"));
    let errors = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{errors}");
    assert_eq!(errors.lines().count(), 1, "{errors}");
    assert!(errors.contains("X display is missing"), "{errors}");
}
