use core::ffi::c_long;

use x11_dl::xlib;

use super::x11::{self, Xlib};
use crate::input::{Action, Button, Input, Mouse, Press};

pub const EVENTS: c_long = xlib::StructureNotifyMask
    | xlib::KeyPressMask
    | xlib::KeyReleaseMask
    | xlib::ButtonPressMask
    | xlib::ButtonReleaseMask
    | xlib::PointerMotionMask;

/// [`note`], for windows that listen. Programs that never do so do not link it.
pub type Note = fn(&mut Vec<Input>, Xlib, &xlib::XEvent, bool);

/// Records an event of a window; auto-repeat sets `is_repeated`.
pub fn note(inputs: &mut Vec<Input>, x: Xlib, event: &xlib::XEvent, is_repeated: bool) {
    // SAFETY: any bits are a valid key event. In button events `keycode` is the button.
    let (kind, event) = unsafe { (event.type_, &event.key) };
    let action = match kind {
        xlib::KeyPress => {
            let press = Press::of(x11::typed(x, event));
            let press = press.filter(|press| !is_repeated || press.repeats());
            inputs.extend(press.map(Input::Key));
            return;
        }
        xlib::ButtonPress => match (event.keycode, button(event.keycode)) {
            (_, Some(button)) => Action::Down(button),
            (4, _) => Action::Wheel(1),
            (5, _) => Action::Wheel(-1),
            _ => return,
        },
        xlib::ButtonRelease => match button(event.keycode) {
            Some(button) => Action::Up(button),
            None => return,
        },
        xlib::MotionNotify => Action::Move,
        _ => return,
    };
    let mouse = Mouse { action, x: event.x, y: event.y };
    inputs.push(Input::Mouse(mouse));
}

fn button(number: u32) -> Option<Button> {
    Some(match number {
        1 => Button::Left,
        2 => Button::Middle,
        3 => Button::Right,
        _ => return None,
    })
}
