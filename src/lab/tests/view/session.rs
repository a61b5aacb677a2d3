use crate::display::{SCENE, SIZE, View, bright, rendered};
use eightfold_stage::{ended, wait_for};
use std::fs;
use std::process::Command;

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

const HINT: &str = "view: the key ? lists the keys\n";

#[test]
fn escape_ends_the_viewer() {
    let Some(view) = View::of_file() else { return };
    view.key("Escape");
    let (_, code, output, errors) = view.process.end();
    assert_eq!((code, &*output, &*errors), (Some(0), "", HINT));
    let files = fs::read_dir(view.folder.path()).expect("a folder");
    assert_eq!(files.count(), 1);
}

#[test]
fn lost_server_is_reported_by_the_viewer() {
    let Some(mut view) = View::new() else { return };
    view.server.process.0.kill().expect("it runs");
    let (_, code, _, errors) = view.process.end();
    assert_eq!(code, Some(1), "{errors}");
    assert!(errors.ends_with("display is lost\n"), "{errors}");
}

#[test]
fn missing_display_is_reported_in_one_line() {
    let mut lab = Command::new(env!("CARGO_BIN_EXE_lab"));
    let (code, _, errors) = ended(lab.arg("view").env_remove("DISPLAY"));
    assert_eq!(code, Some(1), "{errors}");
    assert_eq!(errors.lines().count(), 1, "{errors}");
    assert!(errors.contains("X display is missing"), "{errors}");
}

fn ball(radius: &str) -> String {
    SCENE.replace("radius: 1.0", &format!("radius: {radius}"))
}

#[test]
fn written_or_replaced_file_is_shown() {
    let Some(view) = View::of_file() else { return };
    // Texts of the same length in a row.
    for radius in ["1.4", "0.7", "0.8"] {
        view.write(&ball(radius));
    }
    view.assert_shows_file();
    let [new, old] = ["new", "old"].map(|name| view.folder.path().join(name));
    fs::write(&new, ball("1.4")).expect("it is written");
    fs::rename(&new, &view.file).expect("it is replaced");
    view.assert_shows_file();
    // First missing, then an older file.
    fs::rename(&view.file, &old).expect("it is moved away");
    view.write(&ball("0.7"));
    view.assert_shows_file();
    fs::rename(&old, &view.file).expect("it is replaced");
    view.assert_shows_file();
}

#[test]
fn mistake_is_shown_over_picture() {
    let Some(view) = View::of_file() else { return };
    let picture = view.shot();
    // The height of two lines of text.
    let top = 60 * SIZE[0] as usize;
    for faulty in [ball("1.0.0"), ball("-1.0"), SCENE.replace("\"red\")]", "\"gold\")]")] {
        view.write(&faulty);
        view.assert_shows("text over the picture", |shot| {
            bright(&shot[..top]) > 100 && shot[top..] == picture[top..]
        });
        view.write(SCENE);
        view.assert_shows_file();
    }
    fs::remove_file(&view.file).expect("it is removed");
    view.assert_shows("text", |shot| bright(&shot[..top]) > 100);
    view.write(SCENE);
    view.assert_shows_file();
}
