use eightfold_tracer::Preset;
use eightfold_window::input::Press;

/// The maximum frame rate; Left and Right step by one frame.
pub const FPS: f64 = 60.0;

/// The rays per point shown in white: about the maximum of the model scene, where glass and mirror
/// meet.
pub const MAX_RAYS: u32 = 24;
/// The error shown in white, in 255ths: four times the tables' threshold.
pub const MAX_ERROR: u32 = 32;

pub const KEYS: [(&str, &str); 17] = [
    ("Space", "pauses, resumes"),
    ("Left, Right", "pauses, steps a frame back or on"),
    ("Home", "restarts"),
    ("1 to 9", "exhaustive, finest to fastest, then thesis"),
    ("P", "traced points, white"),
    ("S", "squares: the smaller, the brighter"),
    ("H", "rays per point: black for 0, white for 24 and more"),
    ("E", "error against exhaustive: white for 32/255 and more"),
    ("P, S, H, E again", "the picture"),
    ("Left drag", "orbits the point that the camera looks at"),
    ("Right drag", "pans; so does the middle button"),
    ("Wheel", "zooms"),
    ("V", "the scene's own camera"),
    ("C", "prints the camera for a scene file"),
    ("F, W", "fullscreen, window"),
    ("?, F1", "shows and hides these keys"),
    ("Esc, Q", "quits"),
];

pub fn help() -> String {
    let lines = KEYS.map(|(key, effect)| format!("{key:<18}{effect}"));
    lines.join("\n")
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Overlay {
    None,
    Points,
    Squares,
    Heat,
    Error,
}

impl Overlay {
    const KEYS: [(char, Self, &str); 4] = [
        ('p', Self::Points, "points"),
        ('s', Self::Squares, "squares"),
        ('h', Self::Heat, "heat map"),
        ('e', Self::Error, "error"),
    ];

    pub fn name(self) -> &'static str {
        let row = Self::KEYS.iter().find(|row| row.1 == self);
        row.map_or("picture", |row| row.2)
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Controls {
    /// Fractional while the scene plays.
    pub frame: f64,
    /// In frames; the scene repeats.
    pub length: f64,
    pub is_paused: bool,
    pub quality: Preset,
    pub overlay: Overlay,
}

impl Controls {
    /// Seconds.
    pub fn time(&self) -> f32 {
        (self.frame / FPS) as f32
    }

    pub fn advance(&mut self, frames: f64) {
        if !self.is_paused {
            self.frame = (self.frame + frames) % self.length;
        }
    }

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

    fn step(&mut self, frame: f64) {
        self.is_paused = true;
        self.frame = frame;
    }

    /// Removes the current overlay if chosen again.
    fn choose(&mut self, key: char) {
        if let Some((_, quality)) = ('1'..='9').zip(Preset::ALL).find(|row| row.0 == key) {
            self.quality = quality;
        }
        if let Some(&(_, overlay, _)) = Overlay::KEYS.iter().find(|row| row.0 == key) {
            let is_current = self.overlay == overlay;
            self.overlay = if is_current { Overlay::None } else { overlay };
        }
    }
}
