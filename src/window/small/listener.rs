use core::ffi::{c_int, c_long, c_uint};

use x11_dl::xlib;

use super::x11::{self, Xlib};
use crate::input::{Action, Button, Input, Mouse, Press};

pub const EVENTS: c_long =
    BASIC | xlib::ButtonPressMask | xlib::ButtonReleaseMask | xlib::PointerMotionMask;

/// The events of windows that do not listen.
pub const BASIC: c_long = xlib::StructureNotifyMask | xlib::KeyPressMask | xlib::KeyReleaseMask;

/// A pointer to [`note`], which [`Window::listen`](super::window::Window::listen) stores: programs
/// that never call it do not link `note`.
pub type Note = fn(&mut Vec<Input>, Xlib, &xlib::XEvent, bool);

/// Records an event of a window; auto-repeat sets `is_repeated`.
pub fn note(inputs: &mut Vec<Input>, x: Xlib, event: &xlib::XEvent, is_repeated: bool) {
    // SAFETY: any bits are a valid key event. In button events `keycode` is the button.
    let (kind, event) = unsafe { (event.type_, &event.key) };
    if kind == xlib::KeyPress {
        let press = Press::of(x11::typed(x, event));
        let press = press.filter(|press| !is_repeated || press.repeats());
        inputs.extend(press.map(Input::Key));
    } else if let Some(action) = action(kind, event.keycode) {
        inputs.push(Input::Mouse(Mouse { action, x: event.x, y: event.y }));
    }
}

fn action(kind: c_int, number: c_uint) -> Option<Action> {
    let button = match number {
        1 => Some(Button::Left),
        2 => Some(Button::Middle),
        3 => Some(Button::Right),
        _ => None,
    };
    match (kind, number) {
        (xlib::ButtonPress, 4) => Some(Action::Wheel(1)),
        (xlib::ButtonPress, 5) => Some(Action::Wheel(-1)),
        (xlib::ButtonPress, _) => button.map(Action::Down),
        (xlib::ButtonRelease, _) => button.map(Action::Up),
        (xlib::MotionNotify, _) => Some(Action::Move),
        _ => None,
    }
}
