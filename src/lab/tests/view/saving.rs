//! Properties of a scene file beside its text stay as they are when it is saved.

use crate::stage::{Edit, SCENE, blue, letters, read};
use std::fs::{self, Permissions};
use std::os::unix::fs::{MetadataExt, PermissionsExt, chown};

fn set_mode(edit: &Edit, mode: u32) {
    fs::set_permissions(&edit.file, Permissions::from_mode(mode)).expect("it is set");
}

#[test]
fn it_asks_before_it_writes_over_a_protected_file() {
    let Some(edit) = Edit::changed() else { return };
    set_mode(&edit, 0o444);
    let before = letters(&edit.view.settled_shot());
    edit.view.key("ctrl+s");
    edit.view
        .assert_shows("a question", |shot| letters(shot) > before + 100);
    assert_eq!(edit.text(), SCENE);
    // Another key is an answer, too.
    edit.view.key("l");
    edit.view
        .assert_shows("no question", |shot| letters(shot) == before);
    edit.view.key("ctrl+s");
    edit.view
        .assert_shows("a question", |shot| letters(shot) > before + 100);
    assert_eq!(edit.text(), SCENE);
    assert_eq!(edit.save(), blue());
    let mode = fs::metadata(&edit.file).expect("it is there").mode();
    assert_eq!(mode & 0o777, 0o444);
}

#[test]
fn a_file_of_two_names_stays_one() {
    let Some(edit) = Edit::changed() else { return };
    let name = edit.folder.path().join("name.ron");
    fs::hard_link(&edit.file, &name).expect("a link");
    assert_eq!(edit.save(), blue());
    assert_eq!(read(&name), blue());
}

#[test]
fn owner_and_mode_stay() {
    let Some(edit) = Edit::changed() else { return };
    // More than files get that are made anew.
    set_mode(&edit, 0o666);
    // Only root may give a file away.
    let is_root = chown(&edit.file, Some(65_534), Some(65_534)).is_ok();
    let of = || {
        let file = fs::metadata(&edit.file).expect("it is there");
        (file.mode(), file.uid(), file.gid())
    };
    let before = of();
    assert!(!is_root || before.1 == 65_534);
    assert_eq!(edit.save(), blue());
    assert_eq!(of(), before);
}
