//! The mouse moves the camera in every scene, and C prints it.

use crate::stage::{FileView, SCENE, View, rendered};
use eightfold_stage::wait_for;
use std::io::Read;
use std::thread;

/// A drag from the middle of the window.
const WAY: [[i32; 2]; 3] = [[160, 120], [190, 125], [220, 140]];

#[test]
fn mouse_moves_camera_and_v_resets_it() {
    let Some(view) = View::new("") else { return };
    let picture = rendered("--time 2");
    view.assert_shows("the picture", |shot| shot == picture);
    let mut others = Vec::new();
    for (button, way) in [(1, &WAY[..]), (3, &WAY), (4, &WAY[..1]), (5, &WAY[..1])] {
        view.drag(button, way);
        let moved = view.settled_shot();
        assert!(moved != picture && !others.contains(&moved), "{button}");
        others.push(moved);
        view.key("v");
        view.assert_shows("the picture again", |shot| shot == picture);
    }
}

#[test]
fn red_ball_follows_pan_and_stays_under_orbit() {
    let Some(view) = FileView::new() else { return };
    let is_red = |shot: &[u32], [x, y]: [i32; 2]| {
        let [_, red, _, blue] = shot[(y * 320 + x) as usize].to_be_bytes();
        red > blue
    };
    let [from, .., to] = WAY;
    assert!(is_red(&view.view.shot(), from));
    view.view.drag(1, &WAY);
    let orbited = view.view.settled_shot();
    assert!(is_red(&orbited, from) && !is_red(&orbited, [100, 120]));
    view.view.drag(2, &WAY);
    assert!(is_red(&view.view.settled_shot(), to));
}

#[test]
fn printed_camera_gives_the_picture() {
    for (button, way) in [(1, &WAY[..]), (3, &WAY), (4, &WAY[..1])] {
        let Some(mut view) = FileView::new() else {
            return;
        };
        let before = view.view.shot();
        view.view.drag(button, way);
        let moved = view.view.settled_shot();
        assert!(moved != before);
        let mut output = view.view.process.0.stdout.take().expect("a pipe");
        view.view.key("c");
        let reader = thread::spawn(move || {
            let mut text = [0; 1000];
            let length = output.read(&mut text).expect("text");
            String::from_utf8_lossy(&text[..length]).into_owned()
        });
        wait_for("a line", || reader.is_finished().then_some(()));
        let line = reader.join().expect("it was read");
        let (before, rest) = SCENE.split_once("camera:").expect("a camera");
        let (_, after) = rest.split_once('\n').expect("a line");
        view.write(&format!("{before}{line}{after}"));
        view.view.key("v");
        view.assert_shows_file();
        assert!(view.view.shot() == moved);
    }
}
