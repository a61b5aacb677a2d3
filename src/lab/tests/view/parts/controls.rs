//! The keys of the viewer's controls.

use eightfold_lab::arguments::NamedQuality;
use eightfold_lab::view::controls::{Controls, Overlay};
use eightfold_window::input::Press;

fn controls(frame: f64) -> Controls {
    Controls {
        frame,
        length: 10.0,
        is_paused: false,
        quality: NamedQuality::THESIS,
        overlay: Overlay::None,
    }
}

#[test]
fn steps_go_from_frame_to_frame_and_pause() {
    for (from, press, to) in [
        (3.5, Press::Right, 4.0),
        (3.0, Press::Right, 4.0),
        (9.0, Press::Right, 0.0),
        (3.5, Press::Left, 3.0),
        (3.0, Press::Left, 2.0),
        (0.0, Press::Left, 0.0),
    ] {
        let mut controls = controls(from);
        controls.press(press);
        assert_eq!(controls.frame, to, "{press:?} at {from}");
        assert!(controls.is_paused);
    }
}

#[test]
fn time_stands_still_while_paused_and_goes_round() {
    let mut controls = controls(8.0);
    controls.advance(3.0);
    assert_eq!(controls.frame, 1.0);
    controls.press(Press::Character(' '));
    controls.advance(3.0);
    assert_eq!(controls.frame, 1.0);
    controls.press(Press::Home);
    assert_eq!((controls.frame, controls.is_paused), (0.0, true));
    controls.press(Press::Character(' '));
    controls.advance(0.25);
    assert_eq!(controls.frame, 0.25);
}
