//! `cargo lab view`: plays scenes in a window.

pub mod controls;
pub mod frame_viewer;
mod panel;
mod session;
pub mod subject;

use crate::arguments::{self, within};
use crate::scenes::{self, SceneName};
use anyhow::{Result, anyhow};
use clap::Args;
use controls::{Controls, FPS, Overlay};
use eightfold_harness::Size;
use eightfold_tracer::Preset;
use eightfold_window::cpu;
use eightfold_window::render_target::InnerSize;
use eightfold_window::window::Window;
use frame_viewer::FrameViewer;
use session::Session;
use subject::Subject;

/// Plays the show or a scene in a window, with controls for time, quality and camera
///
/// Reloads a scene file when it changes, and shows mistakes over the last valid picture.
#[derive(Args)]
#[command(after_help = format!("Keys and mouse:\n{}", controls::help()))]
pub struct Arguments {
    #[arg(long, value_name = "NAME", default_value_t = SceneName::Show, help = scenes::names())]
    scene: SceneName,
    /// Width and height of the window in pixels
    #[arg(long, value_name = "WxH", default_value = "1024x768")]
    size: Size,
    #[arg(long, value_name = "NAME", default_value = "default", help = arguments::QUALITY)]
    quality: Preset,
    /// Seconds from the scene's start
    #[arg(long, value_name = "SECONDS", default_value = "0", value_parser = within(0.0..=*arguments::SECONDS.end()), allow_negative_numbers = true)]
    time: f32,
    /// Starts paused
    #[arg(long)]
    paused: bool,
}

pub fn run(arguments: &Arguments) -> Result<()> {
    let Size { width, height } = arguments.size;
    let window = Window::open(c"Eightfold", InnerSize::Exactly(width, height));
    let window = window.map_err(|why| anyhow!("view: {why}"))?;
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
    let viewer = FrameViewer::new(arguments::processors(), cpu::best());
    Session::new(window, viewer, controls, subject).play()
}
