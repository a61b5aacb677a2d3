use crate::arguments::{self, within};
use crate::output;
use crate::scenes::FrameArguments;
use anyhow::Result;
use clap::Args;
use eightfold_harness::picture;
use eightfold_harness::threaded_renderer::drawn;
use eightfold_tracer::Preset;
use std::path::PathBuf;

/// Draws a frame to a PNG file
#[derive(Args)]
pub struct Arguments {
    #[command(flatten)]
    frame: FrameArguments,
    #[arg(long, value_name = "NAME", default_value = "default", help = arguments::QUALITY)]
    quality: Preset,
    /// No antialiasing
    #[arg(long)]
    jagged: bool,
    /// Threads
    #[arg(long, value_name = "N", default_value_t = arguments::processors(), value_parser = within(arguments::THREADS))]
    threads: usize,
    /// PNG file to write, or - for standard output
    #[arg(long, value_name = "FILE", value_parser = arguments::png_file)]
    out: PathBuf,
}

pub fn run(arguments: &Arguments) -> Result<()> {
    let FrameArguments { scene, time, size } = arguments.frame;
    scene.check(time)?;
    let mut quality = *arguments.quality.quality();
    quality.antialias &= !arguments.jagged;
    let pixels = drawn(arguments.threads, &scene.at(time), &quality, size);
    output::write(&arguments.out, &picture::png(size.width, &pixels)?)
}
