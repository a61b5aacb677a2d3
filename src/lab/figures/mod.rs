//! `lab figures`: the figures of the thesis for any frame, and some more.

pub mod sheet;

use crate::arguments::{self, NamedQuality, Size};
use crate::error::Difference;
use crate::flip::Flip;
use crate::overlay::{FrameTrace, heat};
use crate::scenes::{self, SceneName};
use crate::threaded_renderer::ThreadedRenderer;
use crate::{output, picture};
use anyhow::{Context, Result};
use clap::Args;
use eightfold_tracer::Quality;
use eightfold_window::cpu;
use sheet::{Figure, sheet};
use std::fs;
use std::path::PathBuf;

/// Draws how a frame comes about: its points, squares, rays and errors
///
/// Writes a PNG for each, and sheet.png with all of them and captions.
#[derive(Args)]
pub struct Arguments {
    #[arg(long, value_name = "NAME", default_value_t = SceneName::Model, help = scenes::takes())]
    scene: SceneName,
    /// Seconds since the scene's start
    #[arg(long, value_name = "SECONDS", default_value = "0", value_parser = arguments::seconds, allow_negative_numbers = true)]
    time: f32,
    /// Width and height of each picture in pixels
    #[arg(long, value_name = "WxH", default_value = "640x480")]
    size: Size,
    /// How it is refined: exhaustive, thesis, or one of the ladder, from finest to fastest
    #[arg(long, value_name = "NAME", default_value = "default")]
    quality: NamedQuality,
    /// Folder to write the pictures to; it is made where it is missing
    #[arg(long, value_name = "FOLDER", default_value = "target/figures")]
    out: PathBuf,
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> Result<()> {
    let folder = &arguments.out;
    fs::create_dir_all(folder).with_context(|| format!("cannot make {}", folder.display()))?;
    let Size { width, height } = arguments.size;
    let figures = draw(arguments);
    for figure in &figures {
        let png = picture::png(width, &figure.pixels)?;
        output::write(&folder.join(format!("{}.png", figure.name)), &png)?;
    }
    let edges = arguments::edges(arguments.quality.quality.antialias);
    let heading = format!(
        "{} at {} s, {} quality, {edges} edges, {}",
        arguments.scene, arguments.time, arguments.quality, arguments.size
    );
    let (sheet_width, pixels) = sheet(&heading, &figures, width, height)?;
    let png = picture::png(sheet_width, &pixels)?;
    output::write(&folder.join("sheet.png"), &png)
}

/// The figures of the frame that is asked for.
fn draw(arguments: &Arguments) -> Vec<Figure> {
    let Size { width, height } = arguments.size;
    let mut renderer = ThreadedRenderer::new(arguments::processors());
    let scene = arguments.scene.without_overlay(arguments.time);
    let mut draw = |quality: &Quality| {
        let trace = FrameTrace::new(width, height);
        let mut pixels = vec![0; width * height];
        renderer.draw_observed(
            cpu::best().level,
            &scene,
            quality,
            width,
            &mut pixels,
            &trace,
        );
        (pixels, trace)
    };
    // Draw the frame with every pixel traced, and as it is.
    let (exhaustive, all) = draw(&arguments.quality.quality.reference());
    let (picture, trace) = draw(&arguments.quality.quality);
    let over = |mark: &dyn Fn(&mut [u32])| {
        let mut pixels = picture.clone();
        mark(&mut pixels);
        pixels
    };
    // Measure both.
    let area = picture.len() as f64;
    let traced = trace.rays().filter(|&rays| rays > 0).count() as f64 / area;
    let rays = |trace: &FrameTrace| trace.rays().map(u64::from).sum::<u64>() as f64;
    let most = all.rays().max().unwrap_or(1);
    let squares = trace.squares().count();
    let difference = Difference::between(&exhaustive, &picture);
    let flip = Flip::between(width, &exhaustive, &picture);
    let errors = flip.errors.iter();
    // Put the figures together.
    vec![
        Figure::new(
            "points",
            "The points traced",
            format!("{:.1} % of all pixels, white", 100.0 * traced),
            over(&|pixels| trace.draw_points(pixels)),
        ),
        Figure::new(
            "picture",
            "The picture",
            format!("{} to every pixel traced", psnr(&difference)),
            picture.clone(),
        ),
        Figure::new(
            "squares",
            "The squares by size",
            format!("{squares} squares, the brighter the smaller"),
            over(&|pixels| trace.draw_squares(pixels)),
        ),
        Figure::new(
            "rays",
            "Rays of each point traced",
            format!("{:.1} % of all rays", 100.0 * rays(&trace) / rays(&all)),
            over(&|pixels| trace.draw_heat(pixels, most)),
        )
        .up_to(most),
        Figure::new(
            "rays-exhaustive",
            "Rays of each pixel, every pixel traced",
            format!("{:.1} rays a pixel", rays(&all) / area),
            over(&|pixels| all.draw_heat(pixels, most)),
        )
        .up_to(most),
        Figure::new(
            "error",
            "The error that is seen, by FLIP",
            format!(
                "mean {:.4}, 99 % of pixels within {:.3}",
                flip.mean(),
                flip.p99()
            ),
            errors.map(|error| heat(error / FLIP_SHOWN)).collect(),
        )
        .up_to(FLIP_SHOWN),
    ]
}

/// The FLIP error that is shown in white: more than the 99th percentile of the coarsest named quality.
const FLIP_SHOWN: f32 = 0.25;

fn psnr(difference: &Difference) -> String {
    if difference.psnr.is_finite() {
        format!("PSNR {:.1} dB", difference.psnr)
    } else {
        "equal".to_owned()
    }
}
