use crate::arguments::{self, Exit, within};
use clap::Args;
use eightfold::show::{self, tempo};
use eightfold_harness::Size;
use eightfold_scene_file::SceneFile;
use eightfold_tracer::presentation::{Method, Moment, Presentation};
use eightfold_tracer::scene::MAX_SPHERES;
use std::error::Error;
use std::path::Path;
use std::str::FromStr;
use std::{fmt, fs};

const SUFFIX: &str = ".ron";

pub fn text(path: &Path) -> Result<String, String> {
    let error = |why: &str| format!("{}: cannot read: {why}", path.display());
    let bytes = match fs::metadata(path) {
        // Pipes and devices can be endless, and cannot be read again.
        Ok(there) if !there.is_file() => return Err(error("not a regular file")),
        _ => fs::read(path).map_err(|why| error(&why.to_string()))?,
    };
    SceneFile::decode(&path.display().to_string(), bytes)
}

pub fn names() -> String {
    let parts = show::NAMES.join(", ");
    format!(
        "model, field:N (1 to {MAX_SPHERES} spheres), show, show:NAME ({parts}), or FILE{SUFFIX}"
    )
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SceneName {
    Show,
    /// Index in [`show::NAMES`].
    ShowScene(usize),
    Model,
    Field(usize),
    File(&'static SceneFile),
}

impl SceneName {
    pub fn at(self, time: f32) -> Moment {
        match self {
            Self::Model => show::model_scene(time).into(),
            Self::Field(count) => show::field(count, time).into(),
            Self::File(file) => file.at(time),
            Self::Show | Self::ShowScene(_) => {
                let time = self.start().unwrap_or(0.0) + time;
                let mut moment = Moment::default();
                show::at(time.clamp(0.0, show::LENGTH), &mut moment);
                moment
            }
        }
    }

    /// Checks a file's scene at a time that may be outside its length.
    pub fn check(self, time: f32) -> Result<(), Exit> {
        match self {
            Self::File(file) => file.check(time).map_err(Exit::bad_input),
            _ => Ok(()),
        }
    }

    /// Omits overlays that would count as errors: the method's, and captions with counts.
    pub fn without_overlay(self, time: f32) -> Moment {
        let mut moment = self.at(time);
        let Presentation { method, captions, .. } = &mut moment.presentation;
        *method = Method::PLAIN;
        let others = captions.iter().copied();
        *captions = others.filter(|caption| !caption.letters.contains(&b'#')).collect();
        moment
    }

    /// Returns the start in the show, in seconds; `None` for other scenes.
    pub fn start(self) -> Option<f32> {
        match self {
            Self::Show => Some(0.0),
            Self::ShowScene(part) => Some(show::CUTS[part] as f32 * tempo::BAR),
            _ => None,
        }
    }

    /// Seconds.
    pub fn length(self) -> f32 {
        match self {
            Self::Show => show::LENGTH,
            Self::ShowScene(part) => {
                let end = show::CUTS.get(part + 1).unwrap_or(&show::BARS);
                (end - show::CUTS[part]) as f32 * tempo::BAR
            }
            Self::Model | Self::Field(_) => show::MODEL_LENGTH,
            Self::File(file) => file.length,
        }
    }

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
            let file = text(Path::new(name)).and_then(|text| SceneFile::parse(name, &text));
            let file = file.map_err(Exit::bad_input)?;
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
            _ => Err(format!("must be {}", names()).into()),
        }
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

#[derive(Args)]
pub struct FrameArguments {
    #[arg(long, value_name = "NAME", default_value_t = SceneName::Model, help = names())]
    pub scene: SceneName,
    /// Seconds from the scene's start
    #[arg(long, value_name = "SECONDS", default_value = "0", value_parser = within(arguments::SECONDS), allow_negative_numbers = true)]
    pub time: f32,
    /// Width and height in pixels
    #[arg(long, value_name = "WxH", default_value = "640x480")]
    pub size: Size,
}
