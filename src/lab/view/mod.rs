//! `lab view`: plays the show, or edits a scene file, in a window in which keys select time, quality and overlay.
//!
//! `session` is the loop. Keys and the mouse go to `workspace`, which moves the camera and has `editor` change the file's text;
//! what they do not mean anything to goes to `controls`. `document` has that text, `disk` the file, and
//! `copies` the files of what is not saved.

pub mod camera;
pub mod controls;
mod copies;
pub mod disk;
mod document;
mod editor;
mod frame_viewer;
pub mod legend;
mod objects;
pub mod panel;
mod session;
mod workspace;

use crate::arguments::{self, NamedQuality, Size};
use crate::interrupt;
use crate::rate::Rate;
use crate::scenes::{self, SceneName};
use anyhow::{Result, anyhow};
use clap::Args;
use controls::{Controls, Overlay};
use eightfold_window::cpu::{self, Isa};
use eightfold_window::window::Window;
use frame_viewer::FrameViewer;
use session::Session;
use workspace::Workspace;

/// Plays the show in a window, with time and quality under control, and shows what frames are made of
///
/// A scene file is edited by keys and mouse, and read again whenever another program writes it.
///
/// Drawing over a frame what it was made of takes longer than drawing it; the time in the title is that of the frame
/// alone.
#[derive(Args)]
#[command(after_help = format!("Keys:\n{}", legend::text()))]
pub struct Arguments {
    #[arg(long, value_name = "NAME", default_value_t = SceneName::Show, help = scenes::takes())]
    scene: SceneName,
    /// Width and height of the window in pixels
    #[arg(long, value_name = "WxH", default_value = "1024x768")]
    size: Size,
    /// How frames are refined at first: exhaustive, thesis, or one of the ladder, from finest to fastest
    #[arg(long, value_name = "NAME", default_value = "default")]
    quality: NamedQuality,
    /// Where to begin, in seconds
    #[arg(long, value_name = "SECONDS", default_value = "0", value_parser = from_start, allow_negative_numbers = true)]
    time: f32,
    /// Begins with a pause
    #[arg(long)]
    paused: bool,
    /// Frames a second of the show, a whole number or a fraction such as 30000/1001; as many are shown at most
    #[arg(
        long,
        value_name = "RATE",
        default_value = "60",
        allow_negative_numbers = true
    )]
    fps: Rate,
    /// Threads that share the work
    #[arg(long, value_name = "N", default_value_t = arguments::processors(), value_parser = arguments::threads)]
    threads: usize,
    /// Instruction set [default: the best of this machine]
    #[arg(long, value_name = "NAME", value_parser = arguments::instruction_set)]
    isa: Option<Isa>,
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> Result<()> {
    let Size { width, height } = arguments.size;
    let window = Window::open(c"Eightfold", width, height)
        .map_err(|why| anyhow!("view needs a window: {why}"))?;
    eprintln!("view: the key ? lists the keys");
    let rate = arguments.fps.hertz();
    let isa = arguments.isa.unwrap_or_else(cpu::best);
    let workspace = Workspace::open(arguments.scene).map_err(|why| anyhow!(why))?;
    if workspace.editor.is_some() {
        // What is not saved is told of then.
        interrupt::listen();
    }
    let length = f64::from(workspace.length()) * rate;
    let controls = Controls {
        frame: f64::from(arguments.time) * rate % length,
        length,
        is_paused: arguments.paused,
        quality: arguments.quality,
        overlay: Overlay::None,
    };
    let viewer = FrameViewer::new(arguments.threads, isa);
    Session::new(window, viewer, controls, workspace, rate).play()
}

/// Parses a time in the show.
fn from_start(text: &str) -> Result<f32, String> {
    let is_time = |&time: &f32| time.is_finite() && time >= 0.0;
    arguments::parsed(text, is_time, "seconds from 0 on, such as 2.5")
}
