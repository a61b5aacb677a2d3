//! `lab truth`: what a scene would look like by the rendering equation, and what the real-time model leaves out of it.

mod aim;
mod connect;
mod convergence;
pub mod effects;
pub mod estimate;
pub mod film;
pub mod lamp;
mod losses;
pub mod path;
pub mod photons;
mod plan;
pub mod render;
pub mod state;
pub mod surface;
pub mod world;

use crate::arguments::{self, BadInput, Part, Size};
use crate::overlay::heat;
use crate::sampler::{MAX_POINTS, Sequence};
use crate::scenes::{self, SceneName};
use crate::{interrupt, output, picture};
use anyhow::{Context, Result, bail};
use clap::{ArgGroup, Args};
use effects::Effects;
use eightfold_tracer::glam::DVec3;
use eightfold_tracer::scene::{Film, Scene};
use estimate::{Estimate, Intervals};
use exr::prelude::{AnyChannel, AnyChannels, FlatSamples, Image, WritableImage};
use film::Sampling;
use rayon::{ThreadPool, ThreadPoolBuilder};
use render::Picture;
use std::io::Cursor;
use std::path::{Path, PathBuf};

/// The number of independent sequences that sample a pixel: as few as tell the error by their differences.
pub const REPLICATIONS: usize = 8;

/// The half interval, in steps of 1/255, that is shown in white.
const INTERVAL_SHOWN: f64 = 16.0;

/// Draws a scene by a path tracer: lamps with a size, light from surface to surface, glass that bends light
///
/// It follows random paths of light, in numbers of 64 bits, and tells how far each pixel may be off. After Ctrl-C the same
/// command goes on where it was, to the same bits. Parts that many machines have drawn are merged to the same bits, too.
#[derive(Args)]
#[command(group(ArgGroup::new("what").required(true).args(["out", "effects", "convergence"])))]
pub struct Arguments {
    #[arg(long, value_name = "NAME", default_value_t = SceneName::Model, help = scenes::takes())]
    scene: SceneName,
    /// Seconds since the scene's start
    #[arg(long, value_name = "SECONDS", default_value = "0", value_parser = arguments::seconds, allow_negative_numbers = true)]
    time: f32,
    /// Width and height in pixels
    #[arg(long, value_name = "WxH", default_value = "640x480")]
    size: Size,
    /// Paths for each pixel, rounded up to a multiple of 8; the error halves with four times as many, or sooner
    #[arg(long, value_name = "N", default_value = "64", value_parser = samples)]
    samples: usize,
    /// Which paths: pictures with different seeds have independent noise
    #[arg(
        long,
        value_name = "N",
        default_value = "0",
        allow_negative_numbers = true
    )]
    seed: u32,
    /// Effects to add; falloff is that of lamps with the distance, which a scene's own do not have. May be given several times
    #[arg(long, value_name = "EFFECT", value_parser = effects::effect)]
    with: Vec<usize>,
    /// Effects to leave out, for what the real-time model has instead: indirect, caustics, soft-shadows, surfaces. May be given
    /// several times
    #[arg(long, value_name = "EFFECT", value_parser = effects::effect)]
    without: Vec<usize>,
    /// Threads that share the work
    #[arg(long, value_name = "N", default_value_t = arguments::processors(), value_parser = arguments::threads)]
    threads: usize,
    /// File to write as PNG, or - for standard output
    #[arg(long, value_name = "FILE", value_parser = arguments::png_file)]
    out: Option<PathBuf>,
    /// File to write as OpenEXR: the radiance, and half of each pixel's 95 % interval
    #[arg(long, value_name = "FILE", requires = "out")]
    exr: Option<PathBuf>,
    /// File to write the 95 % intervals to, as PNG: from black for none to white for 16 of 255 to either side
    #[arg(long, value_name = "FILE", requires = "out", value_parser = arguments::png_file)]
    interval: Option<PathBuf>,
    /// Draws part I of N of the picture's rows, such as 1/16, to the file of --out with .part-I-of-N behind its name; the others are
    /// drawn by other processes
    #[arg(long, value_name = "I/N", requires = "out", conflicts_with_all = ["exr", "interval", "effects", "convergence"])]
    part: Option<Part>,
    /// Puts together the files of all parts, in place of drawing
    #[arg(long, value_name = "FILE", num_args = 1.., requires = "out",
        conflicts_with_all = ["part", "scene", "time", "size", "samples", "seed", "with", "without", "threads", "effects", "convergence"])]
    merge: Vec<PathBuf>,
    /// Folder for what the real-time model leaves out: pictures of each effect, sheet.png with all of them, and a table
    #[arg(long, value_name = "FOLDER", conflicts_with_all = ["with", "without"])]
    effects: Option<PathBuf>,
    /// Prints how the error falls with the number of paths, by the sampler and by random points
    #[arg(long, conflicts_with_all = ["with", "without"])]
    convergence: bool,
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> Result<()> {
    if !arguments.convergence {
        interrupt::listen();
    } else if arguments.samples <= REPLICATIONS {
        bail!(BadInput(format!(
            "--samples {} takes more than {REPLICATIONS} for --convergence, which compares two numbers of samples at least",
            arguments.samples
        )));
    }
    if let (Some(out), [_, ..]) = (&arguments.out, &*arguments.merge) {
        return write(arguments, &state::merge(&arguments.merge)?, out);
    }
    let scene = shown(arguments)?;
    let picture = Picture {
        scene: &scene,
        size: arguments.size,
        effects: Effects::chosen(&arguments.with, &arguments.without)?,
        sampling: Sampling {
            count: arguments.samples.div_ceil(REPLICATIONS),
            sequence: Sequence::Sobol,
            seed: arguments.seed,
            is_antialiased: true,
        },
    };
    let pool = ThreadPoolBuilder::new().num_threads(arguments.threads);
    let pool = pool.build().context("cannot start threads")?;
    if let Some(folder) = &arguments.effects {
        let name = format!("{} at {} s", arguments.scene, arguments.time);
        losses::run(&picture, &name, &pool, folder)
    } else if let Some(out) = &arguments.out {
        draw(arguments, &picture, &pool, out)
    } else {
        convergence::run(&picture, &arguments.scene.to_string(), &pool)
    }
}

/// Draws one picture, and writes its files; or a part of it.
fn draw(arguments: &Arguments, picture: &Picture<'_>, pool: &ThreadPool, out: &Path) -> Result<()> {
    if let Some(part) = arguments.part {
        part.check(picture.size.height, "rows")?;
        let name = state::beside(out, Some(part));
        output::check(&name)?;
        picture.draw_resumably(pool, out, Some(part), true)?;
        eprintln!(
            "{} has part {part}; --merge takes all parts",
            name.display()
        );
        return Ok(());
    }
    let (exr, interval) = (arguments.exr.as_deref(), arguments.interval.as_deref());
    for name in [exr, interval, Some(out)].into_iter().flatten() {
        output::check(name)?;
    }
    let film = picture.draw_resumably(pool, out, None, false)?;
    write(arguments, &film, out)?;
    render::forget(out);
    Ok(())
}

/// Writes the files of a picture.
fn write(arguments: &Arguments, film: &film::Film, out: &Path) -> Result<()> {
    let estimates = film.estimates();
    let intervals = Intervals::of(&estimates);
    let (width, height) = (film.width, film.rows.len());
    let save = |name: &Path, pixels: &[u32]| output::write(name, &picture::png(width, pixels)?);
    save(out, &pixels(&estimates))?;
    if let Some(name) = &arguments.interval {
        save(name, &interval_picture(&intervals))?;
    }
    if let Some(name) = &arguments.exr {
        output::write(name, &open_exr(Size { width, height }, &estimates)?)?;
    }
    eprintln!(
        "{} samples a pixel: 95 % intervals of +-{:.2} of 255 in the median, +-{:.1} at worst",
        film.count() * REPLICATIONS,
        intervals.median,
        intervals.worst
    );
    Ok(())
}

/// The picture of estimates, as `0x00RRGGBB` pixels.
fn pixels(estimates: &[Estimate]) -> Vec<u32> {
    estimates.iter().map(Estimate::pixel).collect()
}

/// A heat map of intervals.
fn interval_picture(intervals: &Intervals) -> Vec<u32> {
    let all = intervals.all.iter();
    all.map(|&half| heat((half / INTERVAL_SHOWN) as f32))
        .collect()
}

/// The scene at the time, without captions, which no light makes.
fn shown(arguments: &Arguments) -> Result<Scene> {
    let mut scene = arguments.scene.without_overlay(arguments.time);
    undress(&mut scene);
    scene.validate()?;
    Ok(scene)
}

/// Takes away what is no transport of light: captions, copper bars, the film's tone curve, vignette and dither, the glow around lamps.
pub fn undress(scene: &mut Scene) {
    scene.captions.clear();
    scene.copper_bars.clear();
    scene.film = Film::PLAIN;
    for light in scene.lights.iter_mut() {
        light.glow = 0.0;
    }
}

/// Parses a number of samples.
fn samples(text: &str) -> Result<usize, String> {
    arguments::number(text, MAX_POINTS * REPLICATIONS)
}

/// The channels of a colour.
const RGB: [&str; 3] = ["R", "G", "B"];

/// An OpenEXR file, which tells what light a pixel has also where a picture would clip it: radiances as R, G and B, and half the width of their 95 % intervals as interval.R, interval.G and interval.B.
fn open_exr(size: Size, estimates: &[Estimate]) -> Result<Vec<u8>> {
    let channel = |name: String, i: usize, of: &dyn Fn(&Estimate) -> DVec3| {
        let numbers = estimates.iter().map(|estimate| of(estimate)[i] as f32);
        AnyChannel::new(name.as_str(), FlatSamples::F32(numbers.collect()))
    };
    let means = (0..3).map(|i| channel(RGB[i].to_owned(), i, &|estimate| estimate.mean));
    let intervals =
        (0..3).map(|i| channel(format!("interval.{}", RGB[i]), i, &Estimate::half_interval));
    let channels: Vec<_> = means.chain(intervals).collect();
    let image = Image::from_channels(
        (size.width, size.height),
        AnyChannels::sort(channels.into()),
    );
    let mut bytes = Cursor::new(Vec::new());
    let written = image.write().to_buffered(&mut bytes);
    written.context("cannot encode OpenEXR")?;
    Ok(bytes.into_inner())
}
