//! What the viewer has chosen by keys: time, quality, and what is shown of a frame.

use crate::arguments::NamedQuality;
use eightfold_window::window::Press;

/// The keys, for whoever asks.
pub const KEYS: &str = "\
Space         pauses and plays on
Left, Right   a frame back or on, and pauses
Home          back to the beginning
1 to 9        the quality: exhaustive, thesis, then the ladder from the finest to the fastest
P             the points traced, in white
S             the squares: the smaller, the brighter
H             the heat map: rays for each point traced, from black for none to white for 24 and more
E             the error against exhaustive, from black for none to white for 32 of 255 and more
              P, S, H, E again: the picture
F, W          the whole screen, the window
?, F1         these keys
Esc           the end";

/// Rays of a point that are shown in white: as many as any takes where glass and mirrors meet in the model scene.
pub const MOST_RAYS: u32 = 24;
/// Error that is shown in white, of 255: four times what counts as large in the lab's tables.
pub const MOST_ERROR: u32 = 32;

/// What is shown of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    Picture,
    Points,
    Squares,
    Heat,
    Error,
}

impl Look {
    /// As it is called in the title.
    pub fn name(self) -> &'static str {
        match self {
            Self::Picture => "picture",
            Self::Points => "points",
            Self::Squares => "squares",
            Self::Heat => "heat map",
            Self::Error => "error",
        }
    }

    /// Of a key.
    fn of(key: char) -> Option<Self> {
        match key {
            'p' => Some(Self::Points),
            's' => Some(Self::Squares),
            'h' => Some(Self::Heat),
            'e' => Some(Self::Error),
            _ => None,
        }
    }
}

/// What is chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Controls {
    /// Where in the show it is, in frames: between two of them while it plays.
    pub frame: f64,
    /// Frames of the show, after which it begins again.
    pub length: f64,
    pub is_paused: bool,
    pub quality: NamedQuality,
    pub look: Look,
}

impl Controls {
    /// Lets so many frames go by, unless it is paused.
    pub fn advance(&mut self, frames: f64) {
        if !self.is_paused {
            self.frame = (self.frame + frames) % self.length;
        }
    }

    /// Does what a key says. True if it asks for the list of keys.
    pub fn press(&mut self, press: Press) -> bool {
        match press {
            Press::Help => return true,
            Press::Character(' ') => self.is_paused = !self.is_paused,
            Press::Left => self.step((self.frame - 1.0).ceil().max(0.0)),
            Press::Right => self.step((self.frame + 1.0).floor() % self.length.ceil()),
            Press::Home => self.frame = 0.0,
            Press::Character(key) => self.choose(key),
        }
        false
    }

    /// Stands still at a frame.
    fn step(&mut self, frame: f64) {
        self.is_paused = true;
        self.frame = frame;
    }

    /// A quality by its number, or a look: the same key once more leaves it.
    fn choose(&mut self, key: char) {
        let number = key.to_digit(10).map(|digit| digit as usize);
        if let Some(quality) = number.and_then(|number| NamedQuality::all().nth(number - 1)) {
            self.quality = quality;
        }
        if let Some(look) = Look::of(key) {
            self.look = if self.look == look {
                Look::Picture
            } else {
                look
            };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Controls, Look};
    use crate::arguments::NamedQuality;
    use eightfold_window::window::Press;

    fn controls(frame: f64) -> Controls {
        Controls {
            frame,
            length: 10.0,
            is_paused: false,
            quality: NamedQuality::THESIS,
            look: Look::Picture,
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
            assert!(!controls.press(press));
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

    #[test]
    fn digits_choose_the_quality_of_their_number_if_there_is_one() {
        let all: Vec<NamedQuality> = NamedQuality::all().collect();
        let mut controls = controls(0.0);
        for (digit, quality) in ('1'..='9').zip(&all) {
            controls.press(Press::Character(digit));
            assert_eq!(controls.quality, *quality);
        }
        for digit in ('1'..='9').skip(all.len()) {
            let before = controls.quality;
            controls.press(Press::Character(digit));
            assert_eq!(controls.quality, before);
        }
    }

    #[test]
    fn a_look_is_left_by_its_own_key() {
        let mut controls = controls(0.0);
        for (key, look) in [
            ('p', Look::Points),
            ('s', Look::Squares),
            ('h', Look::Heat),
            ('e', Look::Error),
            ('e', Look::Picture),
        ] {
            controls.press(Press::Character(key));
            assert_eq!(controls.look, look);
        }
        assert!(controls.press(Press::Help));
    }
}
