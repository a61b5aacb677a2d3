//! Objects of a scene file are dragged.

use crate::stage::{BALL, Edit, FLOOR, SCENE};

/// The numbers of a vector that stands behind some words of a text.
fn vector(text: &str, words: &str) -> [f64; 3] {
    let (_, after) = text.split_once(words).expect(words);
    let (numbers, _) = after.split_once(')').expect("a bracket");
    let numbers = numbers.split(',').map(|n| n.trim().parse().expect(n));
    numbers.collect::<Vec<f64>>().try_into().expect("three")
}

/// The text of [`SCENE`] with the ball at another place.
fn scene_with(centre: &str) -> String {
    SCENE.replace(
        "/* right */ 0.0, 1.0, 0)",
        &format!("/* right */ {centre})"),
    )
}

#[test]
fn a_drag_moves_an_object_on_its_level() {
    let Some(edit) = Edit::new(SCENE) else { return };
    let [x, y] = BALL;
    edit.view.drag(1, &[BALL, [x + 20, y + 5], [x + 40, y]]);
    let text = edit.save();
    // A pixel is 0.0251 units wide there.
    let moved = vector(&text, "right */");
    assert!((moved[0] - 1.0).abs() < 0.03, "{moved:?}");
    assert_eq!(
        text,
        scene_with(&format!("{:?}, 1.0, 0", moved[0])),
        "no other number"
    );
    edit.assert_unpicked_shows_file();
    // Down is nearer.
    let at = [x + 40, y];
    edit.view.drag(1, &[at, [x + 40, y + 20]]);
    let nearer = vector(&edit.save(), "right */");
    assert!(nearer[2] > 0.5 && nearer[1] == 1.0, "{nearer:?}");
    // What was held is still under the pointer.
    edit.assert_unpicked_shows_file();
    edit.view.drag(1, &[[x + 40, y + 20], at]);
    let back = vector(&edit.save(), "right */");
    assert!(
        (back[0] - moved[0]).abs() < 0.02 && back[2].abs() < 0.02,
        "{back:?}"
    );
}

#[test]
fn a_drag_with_shift_moves_an_object_up_and_down() {
    let Some(edit) = Edit::new(SCENE) else { return };
    let [x, y] = BALL;
    edit.view.server.xdotool("keydown shift");
    edit.view
        .drag(1, &[BALL, [x + 10, y - 20], [x + 10, y - 40]]);
    edit.view.server.xdotool("keyup shift");
    let text = edit.save();
    let moved = vector(&text, "right */");
    assert!(moved[1] > 1.9 && moved[1] < 2.2, "{moved:?}");
    assert_eq!(
        text,
        scene_with(&format!("0.0, {:?}, 0", moved[1])),
        "no other number"
    );
    edit.assert_unpicked_shows_file();
}

#[test]
fn a_tremor_of_a_click_moves_nothing() {
    let Some(edit) = Edit::new(SCENE) else { return };
    let [x, y] = BALL;
    edit.view.drag(1, &[BALL, [x + 2, y - 2]]);
    edit.assert_unpicked_shows_file();
    assert!(!edit.view.title().contains("not saved"));
}

#[test]
fn a_plane_is_dragged_once_it_is_picked() {
    let Some(edit) = Edit::new(SCENE) else { return };
    let [x, y] = FLOOR;
    let to = [x + 30, y];
    // The first drag picks it, and turns the camera.
    edit.view.drag(1, &[FLOOR, to]);
    assert!(!edit.view.title().contains("not saved"));
    let picture = edit.picture();
    edit.view
        .assert_shows("another picture", |shot| shot != picture);
    edit.view.key("v");
    edit.view.drag(1, &[FLOOR, to]);
    let text = edit.save();
    let moved = vector(&text, "planes: [(centre: (");
    assert!(moved[0] > 0.5 && moved[1] == 0.0, "{moved:?}");
    edit.assert_unpicked_shows_file();
}

#[test]
fn an_object_that_moves_is_dragged_with_all_of_its_way() {
    let motions = r#"    motions: [
        // To and fro.
        (of: "spheres[0].centre", repeat: true, keys: [
            (0.0, (0.0, 1.0, 0.0)), // here
            (2.0, (1.5, 1.0, -0.5)),
            (4.0, (0.0, 1.0, 0.0)),
        ]),
    ],
)
"#;
    let text = SCENE.replace("\n)\n", &format!("\n{motions}"));
    let Some(edit) = Edit::new(&text) else { return };
    let [x, y] = BALL;
    edit.view.drag(1, &[BALL, [x + 20, y], [x + 40, y]]);
    let text = edit.save();
    for (words, start) in [
        ("right */", 0.0),
        ("(0.0, (", 0.0),
        ("(2.0, (", 1.5),
        ("(4.0, (", 0.0),
    ] {
        let moved = vector(&text, words);
        assert!((moved[0] - start - 1.0).abs() < 0.03, "{words} {moved:?}");
        assert_eq!(moved[1], 1.0);
    }
    assert!(
        text.contains("// To and fro.") && text.contains(", 1.0, 0.0)), // here"),
        "{text}"
    );
    edit.assert_unpicked_shows_file();
}
