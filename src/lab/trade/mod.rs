//! `lab trade`: measures what speed costs in accuracy, dial by dial.

mod curves;
mod outcome;
mod plots;
mod sweep;
mod table;

use crate::arguments::{self, Size};
use crate::interrupt::Stopped;
use crate::measure::{Plan, Shot};
use crate::scenes::{self, SceneName};
use crate::timing::{evenly_spaced, machine};
use crate::views::views;
use crate::{interrupt, output};
use anyhow::{Context, Result, bail};
use clap::Args;
use curves::Curve;
use eightfold_window::cpu::{self, Isa};
use outcome::{Outcome, mark_front};
use serde::Serialize;
use std::fs;
use std::path::{Path, PathBuf};

/// Turns every dial of the quality, and measures what that gains in speed and costs in accuracy
///
/// Writes trade.json and plots as SVG into a folder, and prints a Markdown table of the Pareto front: the settings than which none
/// is faster, nearer by FLIP and with fewer pops at once, of those that compare colours, objects and lights and miss nothing.
/// Speed is a ratio to exhaustive frames, every pixel traced, that are drawn in between, all on one thread, by its time on a
/// processor; errors are against the same frames. Ctrl-C writes what has been measured so far.
///
/// The dials of a quality are named where they are not as usual: `square` is the side of the squares in pixels, `tolerance` that
/// within which colours fill a square, in 255ths, and `differing` that where objects or lights differ, `side` the tolerance for the
/// middle of a side, `compared` the depths of the objects and of the lights' states that are compared, and the least weight of these,
/// `highlight` the least highlight that is a state, `depth` that of rays, `contribution` the least of a ray.
#[derive(Args)]
pub struct Arguments {
    #[arg(long, value_name = "NAME", default_value_t = SceneName::Model, help = scenes::takes())]
    scene: SceneName,
    /// Width and height in pixels [default: 1024x768, with --quick 512x384]
    #[arg(long, value_name = "WxH")]
    size: Option<Size>,
    /// Antialiases the edges of all frames, the exhaustive ones too; otherwise no frame is antialiased
    #[arg(long)]
    antialias: bool,
    /// Frames of each point against the clock, at times spread evenly [default: 51, with --quick 9]
    #[arg(long, value_name = "N", value_parser = arguments::frames)]
    frames: Option<usize>,
    /// Time of the first frame in seconds
    #[arg(long, value_name = "SECONDS", default_value = "0", value_parser = arguments::seconds, allow_negative_numbers = true)]
    time_from: f32,
    /// Time of the last frame in seconds [default: the scene's end, 25.13 of the model scene, whose orbit it is]
    #[arg(long, value_name = "SECONDS", value_parser = arguments::seconds, allow_negative_numbers = true)]
    time_to: Option<f32>,
    /// Different views, spread evenly, at which FLIP is measured; pixels that pop are counted in the ten frames after each, 60 a
    /// second
    #[arg(long, value_name = "N", default_value = "9", value_parser = arguments::frames)]
    views: usize,
    /// Instruction set [default: the best of this machine]
    #[arg(long, value_name = "NAME", value_parser = arguments::instruction_set)]
    isa: Option<Isa>,
    /// Fewer points and smaller frames: done within some minutes on two cores
    #[arg(long)]
    quick: bool,
    /// Only the named qualities, as a table that documents them, against 64 samples a pixel, too; writes no files
    #[arg(long)]
    ladder: bool,
    /// Folder to write to; it is made where it is missing
    #[arg(long, value_name = "FOLDER", default_value = "target/trade")]
    out: PathBuf,
}

/// All results, as they are written to JSON.
#[derive(Serialize)]
pub struct Trade {
    pub machine: String,
    pub isa: &'static str,
    pub scene: String,
    pub width: usize,
    pub height: usize,
    /// The times of the timed frames, in seconds.
    pub times: Vec<f32>,
    /// The times of the views, in seconds.
    pub views: Vec<f32>,
    /// Whether the edges of all frames are antialiased; otherwise those of none are.
    pub antialias: bool,
    /// Whether everything was measured: false after Ctrl-C.
    pub complete: bool,
    pub points: Vec<Outcome>,
    /// The speed-up relative to exhaustive frames by the number of pixels.
    pub by_resolution: Vec<Curve>,
    /// The time of a frame by the number of spheres, as a multiple of that of an exhaustive frame with one sphere.
    pub by_objects: Vec<Curve>,
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> Result<()> {
    interrupt::listen();
    let plan = plan(arguments)?;
    let folder = &arguments.out;
    if !arguments.ladder {
        fs::create_dir_all(folder).with_context(|| format!("cannot make {}", folder.display()))?;
        output::check(&folder.join("trade.json"))?;
    }
    let trade = measure(arguments, &plan);
    if trade.complete {
        let points = trade.points.iter();
        let points = points.map(|row| (row.is_exact(), row.on_front));
        check(points, arguments.ladder)?;
    }
    let table = if arguments.ladder {
        table::ladder(&trade)
    } else {
        write(folder, &trade)?;
        table::front_table(&trade)
    };
    output::write(Path::new("-"), table.as_bytes())?;
    match (trade.complete, arguments.ladder) {
        (true, _) => {}
        (false, true) => bail!(Stopped("the table holds what was measured".to_owned())),
        (false, false) => {
            let rest = format!("what was measured is in {}", folder.display());
            bail!(Stopped(rest));
        }
    }
    Ok(())
}

/// Whether a table of points would have something to tell, given for each whether it equals the exhaustive frames, and whether it is on
/// the front: with `all` one of them all, otherwise one of the front.
pub fn check(points: impl Iterator<Item = (bool, bool)> + Clone, all: bool) -> Result<()> {
    if points.clone().all(|(is_exact, _)| is_exact) {
        bail!(
            "every setting draws the same at these times: ask for others by --time-from, --time-to or --frames"
        );
    }
    let mut others = points.filter(|(is_exact, _)| !is_exact);
    if !all && !others.any(|(_, on_front)| on_front) {
        bail!(
            "no setting differs from the exhaustive frames and keeps the rules of the front: ask for others by --time-from, --time-to, --frames or --size"
        );
    }
    Ok(())
}

/// The plan of the frames of all points.
fn plan(arguments: &Arguments) -> Result<Plan> {
    arguments::check_span(arguments.time_from, arguments.time_to)?;
    let (width, height, frames) = if arguments.quick {
        (512, 384, 9)
    } else {
        (1024, 768, 51)
    };
    let scene = arguments.scene;
    let (from, to) = (
        arguments.time_from,
        arguments.time_to.unwrap_or(scene.length()),
    );
    let frames = arguments.frames.unwrap_or(frames);
    let times = (0..frames).map(|i| evenly_spaced(from, to, i, frames));
    // The next scene of the show has no part in this one.
    let end = scene.start().map(|_| scene.length());
    let qualities = if arguments.ladder {
        sweep::named()
    } else {
        sweep::qualities(arguments.quick)
    };
    let ways = qualities.into_iter();
    let ways = ways.map(|quality| sweep::way(quality, arguments.antialias));
    Ok(Plan {
        shots: vec![Shot {
            scene,
            times: times.collect(),
            views: views(from, to, arguments.views, end),
        }],
        isa: arguments.isa.unwrap_or_else(cpu::best),
        sizes: vec![arguments.size.unwrap_or(Size { width, height })],
        threads: vec![1],
        ways: ways.collect(),
        is_on_processor: true,
        has_samples: arguments.ladder,
        has_missed: true,
    })
}

fn measure(arguments: &Arguments, plan: &Plan) -> Trade {
    let Arguments {
        quick, antialias, ..
    } = *arguments;
    let settings = plan.measure();
    let has_curves = || !arguments.ladder && !interrupt::is_stopped();
    let (mut by_resolution, mut by_objects) = (Vec::new(), Vec::new());
    if has_curves() {
        by_resolution = curves::by_resolution(plan, quick, antialias);
    }
    if has_curves() {
        by_objects = curves::by_objects(plan, quick, antialias);
    }
    let (size, shot, runs) = (plan.sizes[0], &plan.shots[0], &settings[0].runs);
    let rows = plan.ways.iter().zip(runs);
    let rows = rows.map(|(way, run)| Outcome::of(way, size.area(), run, &runs[0]));
    let mut rows: Vec<Outcome> = rows.collect();
    mark_front(&mut rows);
    Trade {
        machine: machine(),
        isa: plan.isa.name,
        scene: shot.scene.to_string(),
        width: size.width,
        height: size.height,
        times: shot.times.clone(),
        views: shot.views.iter().map(|view| view[0]).collect(),
        antialias,
        complete: !interrupt::is_stopped(),
        points: rows,
        by_resolution,
        by_objects,
    }
}

fn write(folder: &Path, trade: &Trade) -> Result<()> {
    output::write_json(&folder.join("trade.json"), trade)?;
    plots::write(folder, trade)
}
