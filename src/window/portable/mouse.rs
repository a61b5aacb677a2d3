//! The mouse as `minifb` tells of it: where it is and what is held, each time that it is asked.

use std::env;

use minifb::{MouseButton, MouseMode};

use crate::input::{self, Action, Button, Input};

/// The state of the mouse when it was last asked. A click that begins and ends between two frames is missed.
#[derive(Default)]
pub struct Mouse {
    at: (i32, i32),
    held: [bool; BUTTONS.len()],
    /// The part of a notch that the wheel has been turned.
    turned: f32,
}

const BUTTONS: [(MouseButton, Button); 3] = [
    (MouseButton::Left, Button::Left),
    (MouseButton::Middle, Button::Middle),
    (MouseButton::Right, Button::Right),
];

impl Mouse {
    /// Adds what has been done with the mouse since the last call.
    pub fn ask(&mut self, window: &minifb::Window, inputs: &mut Vec<Input>) {
        // While a button is held the pointer counts beyond the window, too.
        let mode = if self.held.contains(&true) {
            MouseMode::Pass
        } else {
            MouseMode::Discard
        };
        let Some((x, y)) = window.get_unscaled_mouse_pos(mode) else {
            return;
        };
        let at = (x.floor() as i32, y.floor() as i32);
        let mut push = |action| {
            let (x, y) = at;
            inputs.push(Input::Mouse(input::Mouse { action, x, y }));
        };
        // Note moves.
        if self.at != at {
            self.at = at;
            push(Action::Move);
        }
        // Note buttons that were pressed or released.
        for (held, (number, button)) in self.held.iter_mut().zip(BUTTONS) {
            let is_down = window.get_mouse_down(number);
            if is_down != *held {
                *held = is_down;
                push(if is_down {
                    Action::Down(button)
                } else {
                    Action::Up(button)
                });
            }
        }
        // Add up parts of notches of the wheel.
        let (_, turned) = window.get_scroll_wheel().unwrap_or_default();
        self.turned += turned / notch();
        let notches = self.turned.trunc();
        self.turned -= notches;
        if notches != 0.0 {
            push(Action::Wheel(notches as i32));
        }
    }
}

/// The number that `minifb` gives for a notch of the wheel away from the hand.
fn notch() -> f32 {
    if cfg!(not(target_os = "linux")) {
        1.0
    } else if env::var_os("WAYLAND_DISPLAY").is_some_and(|name| !name.is_empty()) {
        // Downwards is positive, in pixels.
        -10.0
    } else {
        // A notch is a button on X, whose press and release each count 1.
        2.0
    }
}
