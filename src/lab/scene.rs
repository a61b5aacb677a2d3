//! `lab scene`: writes built-in scenes as scene files, and scene files as Rust.

use crate::arguments::BadInput;
use crate::output;
use crate::rate::Rate;
use crate::scene_file;
use crate::scenes::{self, SceneName};
use anyhow::Result;
use clap::{ArgGroup, Args};
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

/// Runs the command.
pub fn run(arguments: &Arguments) -> Result<()> {
    let text = match (arguments.export, arguments.rust) {
        (Some(name), _) => scene_file::record(name, arguments.fps)?,
        (_, Some(SceneName::File(file))) => scene_file::rust(file)?,
        _ => {
            return Err(BadInput::error(
                "--rust takes a scene file, FILE.ron".to_owned(),
            ));
        }
    };
    output::write(&arguments.out, text.as_bytes())
}
