//! A file beside the scene file holds what is not saved.

use crate::stage::{BALL, Edit, SCENE, blue, letters, read};
use eightfold_stage::{Server, wait_for};
use std::fs;
use std::path::Path;

/// Waits until a file has a text.
#[track_caller]
fn wait_for_text(file: &Path, text: &str) {
    wait_for("the file of what is not saved", || {
        (fs::read_to_string(file).ok()? == text).then_some(())
    });
}

#[test]
fn what_is_dragged_is_kept_meanwhile() {
    let Some(edit) = Edit::new(SCENE) else { return };
    let [x, y] = BALL;
    edit.view.hold(1, &[BALL, [x + 20, y], [x + 40, y]]);
    wait_for("the file of what is not saved", || {
        edit.unsaved().exists().then_some(())
    });
    edit.view.release(1);
    assert_eq!(edit.save().matches("right */ 0.0").count(), 0);
}

#[test]
fn the_file_is_whole_at_any_time() {
    let Some(edit) = Edit::changed() else { return };
    wait_for_text(&edit.unsaved(), &blue());
    // One that is opened before another takes its place is not written to.
    let opened = edit.folder.path().join("opened");
    fs::hard_link(edit.unsaved(), &opened).expect("a link");
    edit.view.click(4, BALL);
    wait_for_text(
        &edit.unsaved(),
        &blue().replace("radius: 1.0", "radius: 1.05"),
    );
    assert_eq!(read(&opened), blue());
}

#[test]
fn what_could_not_be_kept_is_kept_as_soon_as_it_can_be() {
    let Some(edit) = Edit::new(SCENE) else { return };
    edit.view.click(1, BALL);
    let before = letters(&edit.view.settled_shot());
    // Without its folder there is no place for the file.
    let place = edit.folder.path();
    let away = place.with_extension("away");
    fs::rename(place, &away).expect("it is renamed");
    edit.view
        .assert_shows("a fault", |shot| letters(shot) > before + 50);
    let fault = letters(&edit.view.settled_shot());
    edit.view.press("m", "not saved");
    edit.view
        .assert_shows("another", |shot| letters(shot) > fault + 50);
    fs::rename(&away, place).expect("it is renamed");
    wait_for_text(&edit.unsaved(), &blue());
    assert_eq!(edit.save(), blue());
}

#[test]
fn a_file_that_cannot_be_is_not_named_at_the_end() {
    // A name has up to 255 bytes.
    let name = format!("{}.ron", "n".repeat(245));
    let Some(edit) = Edit::on(Server::start, &name, SCENE) else {
        return;
    };
    edit.view.click(1, BALL);
    edit.view.press("m", "not saved");
    edit.view.key("Escape");
    edit.view.key("Escape");
    let Edit { view, folder, .. } = edit;
    let (_, code, _, errors) = view.process.end();
    assert_eq!(code, Some(0));
    assert!(
        errors.contains("are lost: cannot write") && !errors.contains(" are in "),
        "{errors}"
    );
    drop(folder);
}
