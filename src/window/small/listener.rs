use core::mem::take;

use x11_dl::xlib;

use super::x11::{self, Toplevel, Xlib};
use crate::input::{Action, Button, Input, Mouse, Press};

/// Records a window's input. `hear` calls `note` through a pointer: programs that never listen do not link `note`.
pub struct Listener {
    note: fn(&mut Vec<Input>, Xlib, &xlib::XEvent, bool),
    inputs: Vec<Input>,
}

impl Listener {
    pub fn start(top: &Toplevel) -> &'static mut Listener {
        let events = xlib::StructureNotifyMask
            | xlib::KeyPressMask
            | xlib::KeyReleaseMask
            | xlib::ButtonPressMask
            | xlib::ButtonReleaseMask
            | xlib::PointerMotionMask;
        // SAFETY: the window exists.
        unsafe { (top.x.XSelectInput)(top.display, top.window, events) };
        Box::leak(Box::new(Listener { note, inputs: Vec::new() }))
    }

    /// Records an event; auto-repeat sets `is_repeated`.
    pub fn hear(&mut self, x: Xlib, event: &xlib::XEvent, is_repeated: bool) {
        (self.note)(&mut self.inputs, x, event, is_repeated);
    }

    pub fn take(&mut self) -> Vec<Input> {
        take(&mut self.inputs)
    }
}

fn note(inputs: &mut Vec<Input>, x: Xlib, event: &xlib::XEvent, is_repeated: bool) {
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
