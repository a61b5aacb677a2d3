//! A scene file is read again when another program writes it.

use crate::stage::{BALL, Edit, SCENE, View, blue, is_bright, letters, read};
use eightfold_stage::{Server, wait_for};
use std::fs;

/// [`SCENE`] with a larger ball, as another program writes it.
fn larger() -> String {
    SCENE.replace("radius: 1.0", "radius: 1.4")
}

#[test]
fn what_another_program_writes_is_seen() {
    let Some(edit) = Edit::new(SCENE) else { return };
    let before = edit.picture();
    fs::write(&edit.file, larger()).expect("it is written");
    assert!(edit.picture() != before);
    edit.assert_shows_file();
    assert!(!edit.view.title().contains("not saved"));
}

#[test]
fn a_faulty_file_leaves_the_last_picture_with_the_fault_over_it() {
    let Some(edit) = Edit::new(SCENE) else { return };
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
    let Some(edit) = Edit::changed() else { return };
    edit.read_over(&larger());
    // They are in the other file, too.
    assert_eq!(read(&edit.unsaved()), blue());
    edit.assert_unpicked_shows_file();
    edit.view.key("ctrl+z");
    assert_eq!(edit.save(), blue());
}

#[test]
fn the_same_text_written_again_is_not_read_over_changes() {
    let Some(edit) = Edit::changed() else { return };
    fs::write(&edit.file, SCENE).expect("it is written");
    edit.view.settled_shot();
    assert_eq!(edit.save(), blue());
}

#[test]
fn a_later_change_leaves_the_file_of_those_that_were_read_over() {
    let Some(edit) = Edit::changed() else { return };
    edit.read_over(&larger());
    edit.view.click(4, BALL);
    let second = edit.file.with_extension("unsaved-2.ron");
    let changed = SCENE.replace("radius: 1.0", "radius: 1.47");
    wait_for("the second file", || second.exists().then_some(()));
    assert_eq!([read(&edit.unsaved()), read(&second)], [blue(), changed]);
    edit.view.key("ctrl+s");
    edit.wait_until_saved();
    // What is saved needs no other file.
    assert!(!second.exists());
    assert_eq!(read(&edit.unsaved()), blue());
}

#[test]
fn two_that_edit_a_file_keep_what_is_not_saved_apart() {
    let Some(edit) = Edit::new(SCENE) else { return };
    let other = View::of_file(Server::start(640, 480), &edit.file);
    edit.view.click(1, BALL);
    edit.view.press("m", "not saved");
    other.click(1, BALL);
    other.click(4, BALL);
    other.wait("not saved");
    let second = edit.file.with_extension("unsaved-2.ron");
    let resized = SCENE.replace("radius: 1.0", "radius: 1.05");
    wait_for("the second file", || second.exists().then_some(()));
    assert_eq!([read(&edit.unsaved()), read(&second)], [blue(), resized]);
    other.key("ctrl+s");
    edit.wait_until_saved();
    // The first one has read over its changes what the second one has saved.
    assert!(!second.exists());
    assert_eq!(read(&edit.unsaved()), blue());
    edit.view.key("ctrl+z");
    assert_eq!(edit.save(), blue());
}

#[test]
fn what_another_program_writes_ends_a_drag() {
    let [x, y] = BALL;
    let further = [[x + 60, y], [x + 80, y]];
    // Before anything has moved.
    let Some(edit) = Edit::new(SCENE) else { return };
    edit.view.hold(1, &[BALL]);
    let held = edit.view.settled_shot();
    fs::write(&edit.file, larger()).expect("it is written");
    edit.view.assert_shows("what is new", |shot| shot != held);
    edit.view.follow(&further);
    edit.view.release(1);
    edit.view.key("ctrl+s");
    edit.assert_unpicked_shows_file();
    assert_eq!(edit.text(), larger());
    // And after that.
    let Some(edit) = Edit::new(SCENE) else { return };
    edit.view.hold(1, &[BALL, [x + 20, y], [x + 40, y]]);
    edit.view.wait("not saved");
    let before = letters(&edit.view.settled_shot());
    edit.read_over(&larger());
    edit.view.follow(&further);
    edit.view.release(1);
    // It is told until something else is done.
    assert!(letters(&edit.view.settled_shot()) > before + 200);
    edit.view.key("ctrl+s");
    edit.assert_unpicked_shows_file();
    assert_eq!(edit.text(), larger());
    let kept = read(&edit.unsaved());
    edit.view.key("ctrl+z");
    assert_eq!(edit.save(), kept);
    assert!(kept.contains("radius: 1.0") && !kept.contains("right */ 0.0"));
}

#[test]
fn it_asks_before_it_writes_over_what_another_program_has_written() {
    // It can't be read, so that it is not seen.
    let faulty = format!("{SCENE})").into_bytes();
    let latin_1 = [b"// \xe9t\xe9\n", SCENE.as_bytes()].concat();
    let utf_16 = SCENE.encode_utf16().flat_map(u16::to_le_bytes).collect();
    for written in [faulty, latin_1, utf_16] {
        let Some(edit) = Edit::changed() else { return };
        let before = letters(&edit.view.settled_shot());
        fs::write(&edit.file, &written).expect("it is written");
        edit.view
            .assert_shows("the fault", |shot| letters(shot) > before + 50);
        let fault = letters(&edit.view.settled_shot());
        edit.view.key("ctrl+s");
        edit.view
            .assert_shows("a question", |shot| letters(shot) > fault + 100);
        assert_eq!(fs::read(&edit.file).expect("it is there"), written);
        assert_eq!(edit.save(), blue());
        edit.assert_unpicked_shows_file();
    }
}
