//! Changes that are not saved are not lost when it ends.

use crate::stage::{BALL, Edit, SCENE, blue, read};
use eightfold_stage::{Process, Server, is_portable, run};
use std::process::Command;

/// Asserts that it ends with an exit code, and that the changes are in a file that it names.
#[track_caller]
fn assert_ends_with_changes_kept(edit: Edit, code: i32) {
    let (unsaved, file) = (edit.unsaved(), edit.file.clone());
    let Edit { view, folder, .. } = edit;
    let (_, ended, _, errors) = view.process.end();
    assert_eq!(ended, Some(code), "{errors}");
    let name = unsaved.file_name().expect("a name").to_string_lossy();
    assert!(errors.contains(&*name), "no {name} in {errors}");
    assert_eq!(read(&unsaved), blue());
    assert_eq!(read(&file), SCENE);
    drop(folder);
}

fn is_running(process: &mut Process) -> bool {
    process.0.try_wait().expect("it can be asked").is_none()
}

#[test]
fn escape_asks_once_where_something_is_not_saved() {
    let Some(mut edit) = Edit::changed() else {
        return;
    };
    let before = edit.view.settled_shot();
    edit.view.key("Escape");
    edit.view.assert_shows("a question", |shot| shot != before);
    assert!(is_running(&mut edit.view.process));
    // Anything else is an answer, too.
    edit.view.click(1, BALL);
    edit.view.assert_shows("no question", |shot| shot == before);
    edit.view.key("Escape");
    edit.view.assert_shows("a question", |shot| shot != before);
    assert!(is_running(&mut edit.view.process));
    edit.view.key("Escape");
    assert_ends_with_changes_kept(edit, 0);
}

#[test]
fn escape_ends_it_at_once_where_all_is_saved() {
    let Some(edit) = Edit::changed() else { return };
    assert_eq!(edit.save(), blue());
    edit.view.key("Escape");
    let (_, code, _, errors) = edit.view.process.end();
    assert_eq!(code, Some(0), "{errors}");
    assert!(
        errors.contains("wrote ") && errors.ends_with("scene.ron\n"),
        "{errors}"
    );
}

#[test]
fn a_window_that_is_gone_leaves_changes_in_their_file() {
    let Some(edit) = Edit::changed() else { return };
    let close = format!("windowclose {}", edit.view.id());
    edit.view.server.xdotool(&close);
    assert_ends_with_changes_kept(edit, 0);
}

#[test]
fn a_window_that_is_asked_to_close_asks_once() {
    // The portable backend's window closes itself.
    if is_portable() {
        return;
    }
    let Some(edit) = Edit::on(Server::start_managed, "scene.ron", SCENE) else {
        return;
    };
    edit.change();
    let before = edit.view.settled_shot();
    let close = || run(edit.view.server.tool("wmctrl").args(["-c", "Eightfold"]));
    close();
    edit.view.assert_shows("a question", |shot| shot != before);
    close();
    assert_ends_with_changes_kept(edit, 0);
}

#[test]
fn a_signal_leaves_changes_in_their_file() {
    for (signal, code) in [("INT", 130), ("TERM", 143)] {
        let Some(edit) = Edit::changed() else { return };
        let id = edit.view.process.0.id().to_string();
        let sent = Command::new("kill").args(["-s", signal, &id]).status();
        assert!(sent.expect("kill runs").success());
        assert_ends_with_changes_kept(edit, code);
    }
}

#[test]
fn a_server_that_dies_leaves_changes_in_their_file() {
    let Some(mut edit) = Edit::changed() else {
        return;
    };
    edit.view.server.kill();
    let unsaved = edit.unsaved();
    let Edit { view, folder, .. } = edit;
    let (_, code, _, errors) = view.process.end();
    assert_eq!(code, Some(1), "{errors}");
    assert_eq!(read(&unsaved), blue());
    drop(folder);
}
