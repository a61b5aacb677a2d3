//! `lab figures`: the thesis' figures, and more of the kind.

use crate::arguments::{self, NamedQuality, SceneName, Size};
use crate::flip::Flip;
use crate::overlay::{Trail, draw_error, heat};
use crate::studio::Studio;
use crate::{isa, output, picture};
use anyhow::{Context, Result};
use clap::Args;
use eightfold::Quality;
use std::fs;
use std::path::PathBuf;
use std::thread::available_parallelism;

/// Draws how a frame comes about: its points, squares, rays and errors
#[derive(Args)]
pub struct Arguments {
    /// The scene: model, or field:N for N small spheres
    #[arg(long, value_name = "NAME", default_value_t = SceneName::Model)]
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
    #[arg(long, value_name = "FOLDER", default_value = "figures")]
    out: PathBuf,
}

/// Draws the pictures and writes them.
pub fn run(arguments: &Arguments) -> Result<()> {
    let folder = &arguments.out;
    fs::create_dir_all(folder).with_context(|| format!("cannot make {}", folder.display()))?;
    let pictures = draw(arguments);
    for (name, pixels) in &pictures {
        let png = picture::png(arguments.size.width, pixels)?;
        output::write(&folder.join(format!("{name}.png")), &png)?;
    }
    Ok(())
}

fn draw(arguments: &Arguments) -> Vec<(&'static str, Vec<u32>)> {
    let Size { width, height } = arguments.size;
    let mut studio = Studio::new(available_parallelism().map_or(1, usize::from));
    let scene = arguments.scene.at(arguments.time);
    let mut draw = |quality: &Quality| {
        let trail = Trail::new(width, height);
        let mut pixels = vec![0; width * height];
        studio.draw_observed(isa::best().level, &scene, quality, &trail, &mut pixels);
        (pixels, trail)
    };
    let (exhaustive, all) = draw(&Quality::EXHAUSTIVE);
    let (picture, trail) = draw(&arguments.quality.quality);
    let most = all.rays().max().unwrap_or(1);
    let over = |draw: &dyn Fn(&mut [u32])| {
        let mut pixels = picture.clone();
        draw(&mut pixels);
        pixels
    };
    let flip = Flip::between(width, &exhaustive, &picture);
    vec![
        ("points", over(&|pixels| trail.draw_points(pixels))),
        ("squares", over(&|pixels| trail.draw_squares(pixels))),
        ("rays", over(&|pixels| trail.draw_heat(pixels, most))),
        (
            "rays-exhaustive",
            over(&|pixels| all.draw_heat(pixels, most)),
        ),
        ("error", over(&|pixels| draw_error(pixels, &exhaustive, 32))),
        (
            "flip",
            flip.errors.iter().map(|&error| heat(error)).collect(),
        ),
        ("picture", picture),
    ]
}
