use crate::display::{SCENE, View, rendered};
use eightfold_stage::wait_for;
use std::fs;

const MIDDLE: [i32; 2] = [160, 120];
const END: [i32; 2] = [220, 140];
const DRAG: &[[i32; 2]] = &[MIDDLE, [190, 125], END];

fn is_red(shot: &[u32], [x, y]: [i32; 2]) -> bool {
    let [_, red, _, blue] = shot[(y * 320 + x) as usize].to_be_bytes();
    red > blue
}

/// The ball stays in the middle if the camera orbits or zooms, and follows the pointer if it pans.
#[test]
fn moved_camera_is_printed_and_reset() {
    for (button, drag, ball) in [
        (1, DRAG, MIDDLE),
        (2, DRAG, END),
        (3, DRAG, END),
        (4, &DRAG[..1], MIDDLE),
        (5, &DRAG[..1], MIDDLE),
    ] {
        let Some(view) = View::of_file() else { return };
        let before = view.shot();
        view.drag(button, drag);
        let moved = wait_for("another picture that stays", || {
            let shot = view.shot();
            (shot != before && shot == view.shot()).then_some(shot)
        });
        assert!(is_red(&moved, ball), "{button}");
        assert_eq!(is_red(&moved, MIDDLE), ball == MIDDLE, "{button}");
        view.key("c");
        view.key("v");
        view.assert_shows("the file's camera", |shot| shot == before);
        view.key("Escape");
        let View { process, file, folder, .. } = view;
        let (_, _, line, _) = process.end();
        let (start, rest) = SCENE.split_once("    camera:").expect("a camera");
        let (_, end) = rest.split_once('\n').expect("a line");
        fs::write(&file, format!("{start}{line}{end}")).expect("it is written");
        assert!(rendered(&format!("--scene {}", file.display())) == moved, "{line}");
        drop(folder);
    }
}
