//! Input at a window by the keyboard and the mouse, for programs that are worked with, as the lab's viewer is.
//!
//! The intro hears Esc, F, H and W alone, and does not listen to this: what hears it is not in its file.

pub use crate::keyboard::Press;

/// Something that was done at the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Input {
    /// A key was pressed. One that is held comes again and again.
    Key(Press),
    /// Something was done with the mouse.
    Mouse(Mouse),
}

/// An action of the mouse, and where it was.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mouse {
    /// The action.
    pub action: Action,
    /// Pixels of the window, from its left edge; beyond the window while a button is held there.
    pub x: i32,
    /// Pixels of the window, from its upper edge.
    pub y: i32,
}

/// The actions of a mouse.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    /// A button was pressed.
    Down(Button),
    /// A button was let go.
    Up(Button),
    /// The pointer was moved.
    Move,
    /// The wheel was turned by so many notches, away from the hand if positive.
    Wheel(i32),
}

/// A button of the mouse.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Button {
    /// The left one, for right hands.
    Left,
    /// The middle one, or the wheel.
    Middle,
    /// The right one, for right hands.
    Right,
}

/// Adds an input to those that nobody has asked for yet. Of moves that follow each other the last is enough.
pub(crate) fn push(inputs: &mut Vec<Input>, input: Input) {
    let is_move = |input: &Input| {
        matches!(
            input,
            Input::Mouse(Mouse {
                action: Action::Move,
                ..
            })
        )
    };
    match inputs.last_mut() {
        Some(last) if is_move(last) && is_move(&input) => *last = input,
        _ => inputs.push(input),
    }
}

#[cfg(test)]
mod tests {
    use super::{Action, Button, Input, Mouse, push};

    #[test]
    fn moves_in_a_row_are_one_and_clicks_keep_their_order() {
        let mouse = |action, x| Input::Mouse(Mouse { action, x, y: 0 });
        let (down, up) = (Action::Down(Button::Left), Action::Up(Button::Left));
        let mut inputs = Vec::new();
        for input in [
            mouse(Action::Move, 1),
            mouse(Action::Move, 2),
            mouse(down, 2),
            mouse(Action::Move, 3),
            mouse(Action::Move, 4),
            mouse(up, 4),
        ] {
            push(&mut inputs, input);
        }
        let expected = [
            mouse(Action::Move, 2),
            mouse(down, 2),
            mouse(Action::Move, 4),
            mouse(up, 4),
        ];
        assert_eq!(inputs, expected);
    }
}
