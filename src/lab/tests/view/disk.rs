//! A scene file is read again when another program writes it.

use crate::stage::{BALL, Edit, SCENE, is_bright};
use eightfold_stage::{DISPLAY, lacks};
use std::fs;

#[test]
fn what_another_program_writes_is_seen() {
    if lacks(DISPLAY) {
        return;
    }
    let edit = Edit::start(SCENE);
    let before = edit.picture();
    fs::write(&edit.file, SCENE.replace("radius: 1.0", "radius: 1.4")).expect("it is written");
    assert!(edit.picture() != before);
    edit.assert_shows_file();
    assert!(!edit.view.title().contains("not saved"));
}

#[test]
fn a_faulty_file_leaves_the_last_picture_with_the_fault_over_it() {
    if lacks(DISPLAY) {
        return;
    }
    let edit = Edit::start(SCENE);
    let picture = edit.picture();
    for faulty in [
        SCENE.replace("radius: 1.0", "radius: 1.0.0"),
        SCENE.replace("radius: 1.0", "radius: -1.0"),
        SCENE.replace("\"red\"), // it shines", "\"gold\"),"),
    ] {
        fs::write(&edit.file, &faulty).expect("it is written");
        edit.view
            .assert_shows("words over the same picture", |shot| {
                let half = shot.len() / 2;
                let white = shot[..half].iter().filter(|&&pixel| is_bright(pixel));
                white.count() > 100 && shot[half..] == picture[half..]
            });
        assert_eq!(edit.text(), faulty);
    }
    // Until it is mended.
    fs::write(&edit.file, SCENE).expect("it is written");
    edit.assert_shows_file();
}

#[test]
fn changes_that_are_not_saved_come_back_after_the_file_was_read_over_them() {
    if lacks(DISPLAY) {
        return;
    }
    let edit = Edit::start(SCENE);
    edit.view.click(1, BALL);
    edit.view.press("m", "not saved");
    let changed = SCENE.replace("1.0, material: \"red\"", "1.0, material: \"blue\"");
    let other = SCENE.replace("radius: 1.0", "radius: 1.4");
    fs::write(&edit.file, &other).expect("it is written");
    eightfold_stage::wait_for("it to be read", || {
        (!edit.view.title().contains("not saved")).then_some(())
    });
    // They are in the other file, too.
    assert_eq!(
        fs::read_to_string(edit.unsaved()).expect("it is there"),
        changed
    );
    edit.assert_unpicked_shows_file();
    edit.view.key("ctrl+z");
    assert_eq!(edit.save(), changed);
}

#[test]
fn it_asks_before_it_writes_over_what_another_program_has_written() {
    if lacks(DISPLAY) {
        return;
    }
    let edit = Edit::start(SCENE);
    edit.view.click(1, BALL);
    edit.view.press("m", "not saved");
    let letters = |shot: &[u32]| {
        let upper = shot[..shot.len() / 2].iter();
        upper.filter(|&&pixel| is_bright(pixel)).count()
    };
    let before = letters(&edit.view.shot());
    // It can't be read, so that it is not seen.
    let faulty = format!("{SCENE})");
    fs::write(&edit.file, &faulty).expect("it is written");
    edit.view
        .assert_shows("the fault", |shot| letters(shot) > before + 50);
    let fault = letters(&edit.view.shot());
    edit.view.key("ctrl+s");
    edit.view
        .assert_shows("a question", |shot| letters(shot) > fault + 100);
    assert_eq!(edit.text(), faulty);
    let text = edit.save();
    assert_eq!(
        text,
        SCENE.replace("1.0, material: \"red\"", "1.0, material: \"blue\"")
    );
    edit.assert_unpicked_shows_file();
}
