//! Scenes by name: the show, its scenes, the scenes that serve measurements, and scene files.

use crate::arguments::{self, Size};
use clap::Args;
use eightfold::show::{self, grid};
use eightfold_scene_file::SceneFile;
use eightfold_tracer::scene::{MAX_SPHERES, Method, Scene};
use std::error::Error;
use std::path::Path;
use std::str::FromStr;
use std::{fmt, fs};

/// The suffix of scene files.
const SUFFIX: &str = ".ron";

/// Reads the text of a scene file.
///
/// # Errors
/// One line: the file, and why it can't be read.
pub fn text(path: &Path) -> Result<String, String> {
    let cannot = |why: &str| format!("cannot read {}: {why}", path.display());
    let bytes = match fs::metadata(path) {
        // A pipe or a device may have no end, and can't be read again.
        Ok(there) if !there.is_file() => return Err(cannot("it is not a regular file")),
        _ => fs::read(path).map_err(|error| cannot(&error.to_string()))?,
    };
    String::from_utf8(bytes).map_err(|_| cannot("it is not UTF-8"))
}

/// The ways to name a scene, for `--help` and for errors.
pub fn takes() -> String {
    let parts = show::NAMES.map(|part| format!("show:{part}")).join(", ");
    format!(
        "model, field:N for N small spheres, 1 to {MAX_SPHERES}, show, one of its scenes: {parts}, or a scene file, FILE{SUFFIX}"
    )
}

/// A scene by name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SceneName {
    /// The whole show.
    Show,
    /// A scene of the show, as an index in [`show::NAMES`].
    ShowScene(usize),
    /// The model scene.
    Model,
    /// A field with a number of small spheres.
    Field(usize),
    /// A scene file, which is read once and kept as long as the program runs.
    File(&'static SceneFile),
}

impl SceneName {
    /// The scene `time` seconds after its start.
    pub fn at(self, time: f32) -> Scene {
        match self {
            Self::Model => show::model_scene(time),
            Self::Field(count) => show::field(count, time),
            Self::File(file) => file.at(time),
            Self::Show | Self::ShowScene(_) => {
                // Before the show and after it, its first and its last moment are drawn.
                let time = self.start().unwrap_or(0.0) + time;
                let mut scene = Scene::default();
                show::at(time.clamp(0.0, show::LENGTH), &mut scene);
                scene
            }
        }
    }

    /// The same without what explains the method, the overlay and captions that count points: since these differ between qualities,
    /// they would count as errors.
    pub fn without_overlay(self, time: f32) -> Scene {
        let mut scene = self.at(time);
        scene.method = Method::default();
        let captions = scene.captions;
        scene.captions.clear();
        for caption in captions
            .iter()
            .filter(|caption| !caption.letters.contains(&b'#'))
        {
            scene.captions.push(*caption);
        }
        scene
    }

    /// The time at which it starts in the show, in seconds; `None` if it is not part of the show.
    pub fn start(self) -> Option<f32> {
        match self {
            Self::Show => Some(0.0),
            Self::ShowScene(part) => Some(show::CUTS[part] as f32 * grid::BAR),
            Self::Model | Self::Field(_) | Self::File(_) => None,
        }
    }

    /// Its length in seconds.
    pub fn length(self) -> f32 {
        match self {
            Self::Show => show::LENGTH,
            Self::ShowScene(part) => {
                let end = show::CUTS.get(part + 1).unwrap_or(&show::BARS);
                (end - show::CUTS[part]) as f32 * grid::BAR
            }
            Self::Model | Self::Field(_) => show::MODEL_LENGTH,
            Self::File(file) => file.length,
        }
    }

    /// For the show, all its scenes in order; otherwise this scene alone.
    pub fn split(self) -> Vec<Self> {
        match self {
            Self::Show => (0..show::NAMES.len()).map(Self::ShowScene).collect(),
            _ => vec![self],
        }
    }
}

impl FromStr for SceneName {
    type Err = Box<dyn Error + Send + Sync>;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        if name.ends_with(SUFFIX) {
            let text = text(Path::new(name)).map_err(Mistake)?;
            let file = SceneFile::parse(name, &text).map_err(Mistake)?;
            return Ok(Self::File(Box::leak(Box::new(file))));
        }
        let part = name
            .strip_prefix("show:")
            .and_then(|name| show::NAMES.iter().position(|part| *part == name));
        let count = name.strip_prefix("field:").map(str::parse::<usize>);
        match (name, part, count) {
            ("show", ..) => Ok(Self::Show),
            ("model", ..) => Ok(Self::Model),
            (_, Some(part), _) => Ok(Self::ShowScene(part)),
            (_, _, Some(Ok(count))) if (1..=MAX_SPHERES).contains(&count) => Ok(Self::Field(count)),
            _ => Err(format!("takes {}", takes()).into()),
        }
    }
}

/// The mistake in a scene file: one line that begins with its place, `FILE:LINE:COLUMN: `.
#[derive(Debug)]
pub struct Mistake(String);

impl Error for Mistake {}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl fmt::Display for SceneName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Show => write!(f, "show"),
            Self::ShowScene(part) => write!(f, "show:{}", show::NAMES[*part]),
            Self::Model => write!(f, "model"),
            Self::Field(count) => write!(f, "field:{count}"),
            Self::File(file) => f.write_str(&file.name),
        }
    }
}

/// The frame that a command draws.
#[derive(Args)]
pub struct FrameArguments {
    #[arg(long, value_name = "NAME", default_value_t = SceneName::Model, help = takes())]
    pub scene: SceneName,
    /// Seconds since the scene's start
    #[arg(long, value_name = "SECONDS", default_value = "0", value_parser = arguments::seconds, allow_negative_numbers = true)]
    pub time: f32,
    /// Width and height of a picture in pixels
    #[arg(long, value_name = "WxH", default_value = "640x480")]
    pub size: Size,
}
