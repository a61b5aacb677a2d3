//! `lab render`: draws one frame into a PNG file.

use crate::arguments::{self, NamedQuality};
use crate::scenes::FrameArguments;
use crate::threaded_renderer::ThreadedRenderer;
use crate::{output, picture};
use anyhow::Result;
use clap::Args;
use eightfold_window::cpu::{self, Isa};
use std::path::PathBuf;

/// Draws one frame into a PNG file
#[derive(Args)]
pub struct Arguments {
    #[command(flatten)]
    frame: FrameArguments,
    /// How it is refined: exhaustive, thesis, or one of the ladder, from finest to fastest
    #[arg(long, value_name = "NAME", default_value = "default")]
    quality: NamedQuality,
    /// Leaves edges jagged, whatever the quality says
    #[arg(long)]
    jagged: bool,
    /// Threads that share the work
    #[arg(long, value_name = "N", default_value_t = arguments::processors(), value_parser = arguments::threads)]
    threads: usize,
    /// Instruction set [default: the best of this machine]
    #[arg(long, value_name = "NAME", value_parser = arguments::instruction_set)]
    isa: Option<Isa>,
    /// File to write as PNG, or - for standard output
    #[arg(long, value_name = "FILE", value_parser = arguments::png_file)]
    out: PathBuf,
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> Result<()> {
    let size = arguments.frame.size;
    let scene = arguments.frame.scene.at(arguments.frame.time);
    scene.validate()?;
    let mut pixels = vec![0; size.area()];
    let mut quality = arguments.quality.quality;
    quality.antialias &= !arguments.jagged;
    ThreadedRenderer::new(arguments.threads).draw(
        arguments.isa.unwrap_or_else(cpu::best).level,
        &scene,
        &quality,
        size.width,
        &mut pixels,
    );
    output::write(&arguments.out, &picture::png(size.width, &pixels)?)
}
