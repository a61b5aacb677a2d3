//! `lab figures`: shows on one sheet how a frame comes about.

use crate::arguments::{self, NamedQuality, Size};
use crate::error::Difference;
use crate::flip::Flip;
use crate::output;
use crate::overlay::{FrameTrace, heat};
use crate::scenes::FrameArguments;
use crate::sheet::{Tile, sheet};
use crate::threaded_renderer::ThreadedRenderer;
use anyhow::Result;
use clap::Args;
use eightfold_tracer::Quality;
use eightfold_window::cpu;
use std::path::PathBuf;

/// Draws how a frame comes about: its points, squares, rays and errors, on one sheet
#[derive(Args)]
pub struct Arguments {
    #[command(flatten)]
    frame: FrameArguments,
    /// How the frame is refined: exhaustive, thesis, or one of the ladder, from finest to fastest
    #[arg(long, value_name = "NAME", default_value = "default")]
    quality: NamedQuality,
    /// PNG file to write, or - for standard output
    #[arg(long, value_name = "FILE", default_value = "target/figures.png", value_parser = arguments::png_file)]
    out: PathBuf,
}

/// The number of pictures per row.
const COLUMNS: usize = 2;

/// The FLIP error that is shown in white: more than the 99th percentile of the coarsest named quality.
const FLIP_SHOWN: f32 = 0.25;

/// Runs the command.
pub fn run(arguments: &Arguments) -> Result<()> {
    output::check(&arguments.out)?;
    let sheet = sheet(arguments.frame.size, COLUMNS, &figures(arguments))?;
    output::write(&arguments.out, &sheet)
}

/// Draws a frame with every pixel traced, and as the quality has it. Returns the pictures of both.
fn figures(arguments: &Arguments) -> Vec<Tile> {
    let Size { width, height } = arguments.frame.size;
    let mut renderer = ThreadedRenderer::new(arguments::processors());
    let scene = arguments.frame.scene.without_overlay(arguments.frame.time);
    let mut draw = |quality: &Quality| {
        let trace = FrameTrace::new(width, height);
        let mut pixels = vec![0; width * height];
        let level = cpu::best().level;
        renderer.draw_observed(level, &scene, quality, width, &mut pixels, &trace);
        (pixels, trace)
    };
    let quality = arguments.quality.quality;
    let (exhaustive, all) = draw(&quality.reference());
    let (picture, trace) = draw(&quality);
    let flip = Flip::between(width, &exhaustive, &picture);

    let tile = |caption: String, mark: &dyn Fn(&mut [u32])| {
        let mut pixels = picture.clone();
        mark(&mut pixels);
        Tile { pixels, caption }
    };
    let area = picture.len() as f64;
    let traced = trace.rays().filter(|&rays| rays > 0).count() as f64;
    let rays = |trace: &FrameTrace| trace.rays().map(f64::from).sum::<f64>();
    let most = all.rays().max().unwrap_or(1);
    vec![
        tile(
            format!(
                "The points traced, white\n{:.1} % of all pixels",
                100.0 * traced / area
            ),
            &|pixels| trace.draw_points(pixels),
        ),
        tile(
            format!(
                "{} at {} s, {} quality\nPSNR {:.1} dB against every pixel traced",
                arguments.frame.scene,
                arguments.frame.time,
                arguments.quality,
                Difference::between(&exhaustive, &picture).psnr
            ),
            &|_| {},
        ),
        tile(
            format!(
                "The squares: the smaller, the brighter\n{} squares",
                trace.squares().count()
            ),
            &|pixels| trace.draw_squares(pixels),
        ),
        tile(
            format!(
                "Rays of each point, white for {most}\n{:.1} % of all rays",
                100.0 * rays(&trace) / rays(&all)
            ),
            &|pixels| trace.draw_heat(pixels, most),
        ),
        tile(
            format!(
                "Rays of each pixel, every pixel traced, white for {most}\n{:.1} rays per pixel",
                rays(&all) / area
            ),
            &|pixels| all.draw_heat(pixels, most),
        ),
        tile(
            format!(
                "The error by FLIP, white for {FLIP_SHOWN}\nmean {:.4}",
                flip.mean()
            ),
            &|pixels| {
                for (pixel, error) in pixels.iter_mut().zip(&flip.errors) {
                    *pixel = heat(error / FLIP_SHOWN);
                }
            },
        ),
    ]
}
