//! The camera is moved by the mouse, in every scene, and put into scene files.

use crate::stage::{BALL, Edit, NOTHING, SCENE, View, rendered};

/// A drag from the middle of the window.
const WAY: [[i32; 2]; 3] = [BALL, [190, 125], [220, 140]];

#[test]
fn buttons_and_the_wheel_move_the_camera_and_v_takes_it_back() {
    let Some(view) = View::new("") else { return };
    let picture = rendered("--time 2");
    view.assert_shows("the picture", |shot| shot == picture);
    let mut others = Vec::new();
    let gestures: [&dyn Fn(); 4] = [
        &|| view.drag(3, &WAY),
        &|| view.drag(2, &WAY),
        &|| view.click(4, BALL),
        &|| view.click(5, BALL),
    ];
    for gesture in gestures {
        gesture();
        let moved = view.settled_shot();
        assert!(moved != picture && !others.contains(&moved));
        others.push(moved);
        view.key("v");
        view.assert_shows("the picture again", |shot| shot == picture);
    }
    // The left button does the same as the right one, where it has no object to drag.
    view.drag(1, &WAY);
    view.assert_shows("the first of these", |shot| shot == others[0]);
}

#[test]
fn c_puts_the_camera_into_the_file() {
    for gesture in [1, 2, 4] {
        let Some(edit) = Edit::new(SCENE) else { return };
        let before = edit.picture();
        match gesture {
            1 => edit.view.drag(1, &[NOTHING, [60, 40]]),
            2 => edit.view.drag(2, &WAY),
            _ => edit.view.click(4, NOTHING),
        }
        edit.view
            .assert_shows("another picture", |shot| shot != before);
        assert!(
            !edit.view.title().contains("not saved"),
            "looking is no change"
        );
        edit.view.key("c");
        let text = edit.save();
        let fields = |text: &str| {
            let (start, rest) = text.split_once("eye: (").expect("an eye");
            let (eye, rest) = rest.split_once("), look_at: (").expect("in the same place");
            let (look_at, end) = rest.split_once("), field").expect("as before");
            [start, eye, look_at, end].map(str::to_owned)
        };
        let ([start, eye, look_at, end], old) = (fields(&text), fields(SCENE));
        assert_eq!([&start, &end], [&old[0], &old[3]], "comments and all else");
        assert!(
            eye != old[1] && (look_at != old[2]) == (gesture == 2),
            "{text}"
        );
        edit.assert_shows_file();
    }
}
