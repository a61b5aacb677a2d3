//! Scenes by name: the show, the scenes that it is made of, and those that stand alone.

use eightfold::scene::{MAX_SPHERES, Method, Scene};
use eightfold::show::{self, grid};
use std::fmt;
use std::str::FromStr;

/// The scenes of the show, which begin at [`grid::CUTS`].
pub const PARTS: [&str; grid::CUTS.len()] = [
    "title",
    "model",
    "method",
    "colonnade",
    "machine",
    "field",
    "finale",
];

/// A scene by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SceneName {
    /// The whole show.
    Show,
    /// The scene of the show with this place in [`PARTS`].
    Part(usize),
    /// The scene of every measurement.
    Model,
    /// A field of so many small spheres.
    Field(usize),
}

impl SceneName {
    /// What is drawn `time` seconds after its start.
    pub fn at(self, time: f32) -> Scene {
        match self {
            Self::Model => show::scene(time),
            Self::Field(count) => show::field(count, time),
            Self::Show | Self::Part(_) => {
                // There is nothing before the show and after it.
                let time = self.start().unwrap_or(0.0) + time;
                let mut scene = Scene::default();
                show::at(time.clamp(0.0, grid::SHOW_LENGTH), &mut scene);
                scene
            }
        }
    }

    /// As [`Self::at`], without the marks of how it is drawn: those of one quality are no errors of another.
    pub fn unmarked(self, time: f32) -> Scene {
        let mut scene = self.at(time);
        scene.method = Method::default();
        scene
    }

    /// When it starts in the show, in seconds, if it is played to the soundtrack.
    pub fn start(self) -> Option<f32> {
        match self {
            Self::Show => Some(0.0),
            Self::Part(part) => Some(grid::CUTS[part] as f32 * grid::BAR),
            Self::Model | Self::Field(_) => None,
        }
    }

    /// Seconds until it ends, or begins again.
    pub fn length(self) -> f32 {
        match self {
            Self::Show => grid::SHOW_LENGTH,
            Self::Part(part) => {
                let end = grid::CUTS.get(part + 1).unwrap_or(&grid::BARS);
                (end - grid::CUTS[part]) as f32 * grid::BAR
            }
            Self::Model | Self::Field(_) => show::MODEL_LENGTH,
        }
    }

    /// The scenes of the show in their order, or this one alone.
    pub fn parts(self) -> Vec<Self> {
        match self {
            Self::Show => (0..PARTS.len()).map(Self::Part).collect(),
            _ => vec![self],
        }
    }
}

impl FromStr for SceneName {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        let part = name
            .strip_prefix("show:")
            .and_then(|name| PARTS.iter().position(|part| *part == name));
        let count = name.strip_prefix("field:").map(str::parse::<usize>);
        match (name, part, count) {
            ("show", ..) => Ok(Self::Show),
            ("model", ..) => Ok(Self::Model),
            (_, Some(part), _) => Ok(Self::Part(part)),
            (_, _, Some(Ok(count))) if (1..=MAX_SPHERES).contains(&count) => Ok(Self::Field(count)),
            _ => {
                let parts = PARTS.map(|part| format!("show:{part}")).join(", ");
                Err(format!(
                    "takes model, field:N for N small spheres, 1 to {MAX_SPHERES}, show, or one of its scenes: {parts}"
                ))
            }
        }
    }
}

impl fmt::Display for SceneName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Show => write!(f, "show"),
            Self::Part(part) => write!(f, "show:{}", PARTS[*part]),
            Self::Model => write!(f, "model"),
            Self::Field(count) => write!(f, "field:{count}"),
        }
    }
}
