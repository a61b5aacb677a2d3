//! `lab view`: plays a scene in a window in which keys select time, quality and overlay, and the mouse moves the camera.
//!
//! `session` is the loop. `subject` is the scene that it shows: `watched` reads its file again whenever that is written, and `camera`
//! moves the camera. `controls` has the keys.

mod camera;
pub mod controls;
pub mod frame_viewer;
mod panel;
mod session;
pub mod subject;
mod watched;

use crate::arguments::{self, NamedQuality, Size};
use crate::scenes::{self, SceneName};
use anyhow::{Result, anyhow};
use clap::Args;
use controls::{Controls, FPS, Overlay};
use eightfold_window::cpu::{self, Isa};
use eightfold_window::window::Window;
use frame_viewer::FrameViewer;
use session::Session;
use subject::Subject;

/// Plays the show or a scene in a window, with time, quality and camera under control
///
/// A scene file is read again whenever it is written. A mistake in it is shown over the last good picture.
#[derive(Args)]
#[command(after_help = format!("Keys and mouse:\n{}", controls::help()))]
pub struct Arguments {
    #[arg(long, value_name = "NAME", default_value_t = SceneName::Show, help = scenes::takes())]
    scene: SceneName,
    /// Width and height of the window in pixels
    #[arg(long, value_name = "WxH", default_value = "1024x768")]
    size: Size,
    /// Quality at the start: exhaustive, thesis, or one of the ladder, from finest to fastest
    #[arg(long, value_name = "NAME", default_value = "default")]
    quality: NamedQuality,
    /// Time at the start, in seconds
    #[arg(long, value_name = "SECONDS", default_value = "0", value_parser = from_start, allow_negative_numbers = true)]
    time: f32,
    /// Starts paused
    #[arg(long)]
    paused: bool,
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
    let subject = Subject::new(arguments.scene);
    let length = f64::from(subject.length()) * FPS;
    let controls = Controls {
        frame: f64::from(arguments.time) * FPS % length,
        length,
        is_paused: arguments.paused,
        quality: arguments.quality,
        overlay: Overlay::None,
    };
    let isa = arguments.isa.unwrap_or_else(cpu::best);
    let viewer = FrameViewer::new(arguments.threads, isa);
    Session::new(window, viewer, controls, subject).play()
}

/// Parses a time in the scene.
fn from_start(text: &str) -> Result<f32, String> {
    let is_time = |&time: &f32| time.is_finite() && time >= 0.0;
    arguments::parsed(text, is_time, "seconds from 0 on, such as 2.5")
}
