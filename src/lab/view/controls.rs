//! Keys of the viewer: time, quality and overlay.

use crate::arguments::NamedQuality;
use eightfold_window::input::Press;

/// Frames per second: the length of a step, and the most that are shown.
pub const FPS: f64 = 60.0;

/// The number of rays of a point that is shown in white: about the largest in the model scene, where glass and mirror meet.
pub const MOST_RAYS: u32 = 24;
/// The error that is shown in white, in steps of 1/255: four times the error that the lab's tables count as large.
pub const MOST_ERROR: u32 = 32;

/// Keys and gestures with their effects.
pub const KEYS: [(&str, &str); 17] = [
    ("Space", "pauses, plays on"),
    ("Left, Right", "a frame back or on, and pauses"),
    ("Home", "back to the start"),
    (
        "1 to 9",
        "quality: exhaustive, thesis, then the finest to the fastest",
    ),
    ("P", "points traced, in white"),
    ("S", "squares: the smaller, the brighter"),
    ("H", "rays per point: black for none, white for 24 and more"),
    (
        "E",
        "error against exhaustive: black for none, white for 32/255 and more",
    ),
    ("P, S, H, E again", "the picture"),
    (
        "Left drag",
        "turns the camera about the point that it looks at",
    ),
    (
        "Right drag",
        "moves the camera sideways; so does the middle button",
    ),
    ("Wheel", "nearer, farther"),
    ("V", "the scene's own camera"),
    ("C", "prints the camera for a scene file"),
    ("F, W", "fullscreen, window"),
    ("?, F1", "shows and hides these keys"),
    ("Esc", "quits"),
];

/// Returns the keys as lines for a terminal.
pub fn help() -> String {
    let lines = KEYS.map(|(key, effect)| format!("{key:<18}{effect}"));
    lines.join("\n")
}

/// The overlay that is drawn over the frame, or instead of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Overlay {
    None,
    Points,
    Squares,
    Heat,
    Error,
}

impl Overlay {
    /// Returns the name in the window's title.
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "picture",
            Self::Points => "points",
            Self::Squares => "squares",
            Self::Heat => "heat map",
            Self::Error => "error",
        }
    }

    /// Returns the overlay that a key selects.
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

/// The selection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Controls {
    /// The position in the scene, in frames; while it plays it lies between frames.
    pub frame: f64,
    /// The length of the scene in frames. The scene repeats.
    pub length: f64,
    pub is_paused: bool,
    pub quality: NamedQuality,
    pub overlay: Overlay,
}

impl Controls {
    /// Returns the position in seconds.
    pub fn time(&self) -> f32 {
        (self.frame / FPS) as f32
    }

    /// Advances by a number of frames, unless paused.
    pub fn advance(&mut self, frames: f64) {
        if !self.is_paused {
            self.frame = (self.frame + frames) % self.length;
        }
    }

    /// Applies a key.
    pub fn press(&mut self, press: Press) {
        match press {
            Press::Character(' ') => self.is_paused = !self.is_paused,
            Press::Left => self.step((self.frame - 1.0).ceil().max(0.0)),
            Press::Right => self.step((self.frame + 1.0).floor() % self.length.ceil()),
            Press::Home => self.frame = 0.0,
            Press::Character(key) => self.choose(key),
            _ => {}
        }
    }

    /// Pauses at a frame.
    fn step(&mut self, frame: f64) {
        self.is_paused = true;
        self.frame = frame;
    }

    /// Selects a quality by its number, or an overlay. The key of the current overlay removes it.
    fn choose(&mut self, key: char) {
        let number = key.to_digit(10).map(|digit| digit as usize);
        if let Some(quality) = number.and_then(|number| NamedQuality::all().nth(number - 1)) {
            self.quality = quality;
        }
        if let Some(overlay) = Overlay::of(key) {
            self.overlay = if self.overlay == overlay {
                Overlay::None
            } else {
                overlay
            };
        }
    }
}
