use std::env;

use minifb::{MouseButton, MouseMode};

use crate::input::{self, Action, Button, Input};

/// The mouse's state at the last poll. Clicks between two polls are lost.
#[derive(Default)]
pub struct Mouse {
    at: (i32, i32),
    held: [bool; BUTTONS.len()],
    turned: f32,
}

const BUTTONS: [(MouseButton, Button); 3] = [
    (MouseButton::Left, Button::Left),
    (MouseButton::Middle, Button::Middle),
    (MouseButton::Right, Button::Right),
];

impl Mouse {
    pub fn poll(&mut self, window: &minifb::Window, inputs: &mut Vec<Input>) {
        // While a button is held, positions outside the window count too.
        let mode = if self.held.contains(&true) { MouseMode::Pass } else { MouseMode::Discard };
        let Some((x, y)) = window.get_unscaled_mouse_pos(mode) else {
            return;
        };
        let at = (x.floor() as i32, y.floor() as i32);
        let mut push = |action| {
            let (x, y) = at;
            inputs.push(Input::Mouse(input::Mouse { action, x, y }));
        };
        if self.at != at {
            self.at = at;
            push(Action::Move);
        }
        for (held, (number, button)) in self.held.iter_mut().zip(BUTTONS) {
            let is_down = window.get_mouse_down(number);
            if is_down != *held {
                *held = is_down;
                push(if is_down { Action::Down(button) } else { Action::Up(button) });
            }
        }
        let (_, turned) = window.get_scroll_wheel().unwrap_or_default();
        self.turned += turned / notch();
        let notches = self.turned.trunc();
        self.turned -= notches;
        if notches != 0.0 {
            push(Action::Wheel(notches as i32));
        }
    }
}

/// A notch of the wheel away from the user, in `minifb`'s unit.
fn notch() -> f32 {
    if cfg!(not(target_os = "linux")) {
        1.0
    } else if env::var_os("WAYLAND_DISPLAY").is_some_and(|name| !name.is_empty()) {
        // Pixels, positive downwards.
        -10.0
    } else {
        // On X a notch is a button, whose press and release both count 1.
        2.0
    }
}
