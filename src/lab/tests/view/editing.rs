//! Objects of a scene file are picked and changed, and the file keeps all else as it is.

use crate::stage::{BALL, Edit, FLOOR, NOTHING, SCENE, SIZE, blue, is_bright};

/// The line of the ball in [`SCENE`].
const LINE: &str =
    "        (centre: (/* right */ 0.0, 1.0, 0), radius: 1.0, material: \"red\"), // it shines\n";

#[test]
fn a_click_shows_what_is_picked_and_its_numbers() {
    let Some(edit) = Edit::new(SCENE) else { return };
    let picture = edit.picture();
    let [width, height] = SIZE.map(|side| side as usize);
    // White letters at the lower edge, and white corners around the ball.
    let letters = |shot: &[u32]| {
        let line = &shot[(height - 24) * width..];
        line.iter().filter(|&&pixel| is_bright(pixel)).count()
    };
    let corners = |shot: &[u32]| {
        let rows = (height / 2 - 60)..(height / 2 + 60);
        let pixels = rows.flat_map(|y| (100..220).map(move |x| y * width + x));
        pixels
            .filter(|&at| shot[at] == 0x00ff_ffff && picture[at] != 0x00ff_ffff)
            .count()
    };
    edit.view.click(1, BALL);
    let is_told = |shot: &[u32]| letters(shot) > 100 && corners(shot) > 40;
    edit.view.assert_shows("the ball's numbers", is_told);
    let ball = edit.view.settled_shot();
    edit.view.click(1, FLOOR);
    edit.view.assert_shows("the floor's numbers", |shot| {
        letters(shot) > 100 && corners(shot) < 40 && shot != ball
    });
    edit.assert_unpicked_shows_file();
    assert_eq!(edit.text(), SCENE);
    assert!(!edit.view.title().contains("not saved"));
}

#[test]
fn the_wheel_resizes_what_is_picked_under_it() {
    let Some(edit) = Edit::new(SCENE) else { return };
    edit.view.click(1, BALL);
    edit.view.click(4, BALL);
    let expected = SCENE.replace("radius: 1.0", "radius: 1.05");
    assert_eq!(edit.save(), expected);
    edit.assert_unpicked_shows_file();
    edit.view.click(1, BALL);
    edit.view.click(5, BALL);
    edit.view.click(5, BALL);
    assert_eq!(edit.save(), SCENE.replace("radius: 1.0", "radius: 0.952"));
    // Notches that follow each other are undone as one.
    edit.view.key("ctrl+z");
    assert_eq!(edit.save(), expected);
}

#[test]
fn the_wheel_resizes_a_light_that_is_drawn() {
    let lit = SCENE.replace("(4.0, 6.0, 4.0)", "(0.0, 1.75, 3.0), drawn_radius: 0.5");
    let Some(edit) = Edit::new(&lit) else { return };
    edit.view.click(1, BALL);
    edit.view.click(4, BALL);
    assert_eq!(edit.save(), lit.replace("radius: 0.5", "radius: 0.525"));
}

#[test]
fn m_steps_through_the_materials() {
    let Some(edit) = Edit::new(SCENE) else { return };
    edit.view.click(1, BALL);
    edit.view.key("m");
    assert_eq!(edit.save(), blue());
    edit.view.key("m");
    assert_eq!(edit.save(), SCENE);
    edit.assert_unpicked_shows_file();
}

#[test]
fn delete_takes_an_object_away() {
    let Some(edit) = Edit::new(SCENE) else { return };
    edit.view.click(1, BALL);
    edit.view.key("Delete");
    assert_eq!(edit.save(), SCENE.replace(LINE, ""));
    // It is picked no more.
    edit.assert_shows_file();
    edit.view.click(1, FLOOR);
    edit.view.key("Delete");
    let text = edit.save();
    assert!(text.contains("planes: []"), "{text}");
}

#[test]
fn control_d_puts_a_copy_beside_an_object() {
    let Some(edit) = Edit::new(SCENE) else { return };
    edit.view.click(1, BALL);
    edit.view.key("ctrl+d");
    let copy = LINE
        .replace("0.0, 1.0", "2.2, 1.0")
        .replace(" // it shines", "");
    assert_eq!(edit.save(), SCENE.replace(LINE, &format!("{LINE}{copy}")));
    // The copy is picked.
    edit.view.key("Delete");
    assert_eq!(edit.save(), SCENE);
    edit.assert_unpicked_shows_file();
}

#[test]
fn steps_are_undone_and_done_again() {
    let Some(edit) = Edit::new(SCENE) else { return };
    edit.view.click(1, BALL);
    edit.view
        .drag(1, &[BALL, [170, 125], [180, 130], [200, 140]]);
    edit.view.key("m");
    edit.view.press("Delete", "not saved");
    // A drag is one step.
    for _ in 0..3 {
        edit.view.key("ctrl+z");
    }
    edit.wait_until_saved();
    edit.assert_unpicked_shows_file();
    assert_eq!(edit.text(), SCENE);
    for _ in 0..2 {
        edit.view.key("ctrl+y");
    }
    let text = edit.save();
    assert!(text.contains("1.0, material: \"blue\"") && !text.contains("right */ 0.0"));
    edit.assert_shows_file();
}

#[test]
fn what_cannot_be_is_told_and_changes_nothing() {
    let Some(edit) = Edit::new(SCENE) else { return };
    let picture = edit.picture();
    for key in ["m", "Delete", "ctrl+d", "ctrl+z", "ctrl+y"] {
        edit.view.key(key);
        edit.view.assert_shows("words at the top", |shot| {
            let top = &shot[..20 * SIZE[0] as usize];
            let white = top.iter().filter(|&&pixel| is_bright(pixel));
            white.count() > 50
        });
        edit.view.click(1, NOTHING);
        edit.view.assert_shows("no words", |shot| shot == picture);
    }
    assert_eq!(edit.text(), SCENE);
    assert!(!edit.view.title().contains("not saved"));
}
