//! `lab scene`: writes built-in scenes as scene files, and scene files as Rust.

use crate::arguments::BadInput;
use crate::output;
use crate::rate::Rate;
use crate::scenes::{self, SceneName};
use anyhow::{Result, bail};
use clap::{ArgGroup, Args};
use eightfold_scene_file as scene_file;
use std::path::PathBuf;

/// Writes a built-in scene as a scene file, or a scene file as Rust
#[derive(Args)]
#[command(group(ArgGroup::new("what").required(true).args(["export", "rust"])))]
pub struct Arguments {
    #[arg(long, value_name = "NAME", help = format!("Writes a scene as a scene file: {}", scenes::takes()))]
    export: Option<SceneName>,
    /// Frames a second at which an exported scene is as it was, to the bit; between them it is interpolated
    #[arg(long, value_name = "N", default_value = "60", requires = "export")]
    fps: Rate,
    /// Writes a scene file as a Rust module with a function that gives the scene at a time
    #[arg(long, value_name = "FILE.ron")]
    rust: Option<SceneName>,
    /// File to write, or - for standard output
    #[arg(long, value_name = "FILE", default_value = "-")]
    out: PathBuf,
}

/// The text of a file that shows a scene as it is at the times of so many frames a second.
///
/// # Errors
/// If the scene changes by more than its numbers.
pub fn record(name: SceneName, fps: Rate) -> Result<String> {
    let frames = (0..fps.frames(name.length())).map(|frame| fps.time(frame));
    let scenes = frames.map(|time| (time, name.at(time))).collect();
    scene_file::text_of(&name.to_string(), name.length(), scenes)
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> Result<()> {
    let text = match (arguments.export, arguments.rust) {
        (Some(name), _) => record(name, arguments.fps)?,
        (_, Some(SceneName::File(file))) => scene_file::rust(file)?,
        _ => bail!(BadInput("--rust takes a scene file, FILE.ron".to_owned())),
    };
    output::write(&arguments.out, text.as_bytes())
}
