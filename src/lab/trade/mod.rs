//! `lab trade`: measures what speed costs in accuracy, dial by dial.

mod curves;
mod measure;
mod outcome;
mod plots;
mod sweep;
mod table;

use crate::arguments::{self, NamedQuality, Size};
use crate::interrupt::Stopped;
use crate::scenes::{self, SceneName};
use crate::timing::machine;
use crate::views::views;
use crate::{interrupt, output, progress};
use anyhow::{Context, Result, bail};
use clap::Args;
use curves::{Curve, Curves};
use eightfold_window::cpu::{self, Isa};
use measure::{Measurement, Plan};
use outcome::{Outcome, mark_front};
use serde::Serialize;
use std::fs;
use std::path::{Path, PathBuf};
use sweep::Point;

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

impl Trade {
    /// The edges of all frames, in a word.
    fn edges(&self) -> &'static str {
        if self.antialias {
            "antialiased"
        } else {
            "jagged"
        }
    }
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
    let mut points = if arguments.ladder {
        sweep::named()
    } else {
        sweep::points(arguments.quick)
    };
    for point in &mut points {
        point.antialias(arguments.antialias);
    }
    let trade = measure(arguments, &plan, points);
    if trade.complete && trade.points.iter().all(Outcome::is_exact) {
        bail!(
            "every setting draws the same at these times: ask for others by --time-from, --time-to or --frames"
        );
    }
    let on_front = |row: &Outcome| row.on_front && !row.is_exact();
    if trade.complete && !arguments.ladder && !trade.points.iter().any(on_front) {
        bail!(
            "no setting differs from the exhaustive frames and keeps the rules of the front: ask for others by --time-from, --time-to, --frames or --size"
        );
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
    // The next scene of the show has no part in this one.
    let end = scene.start().map(|_| scene.length());
    Ok(Plan {
        scene,
        isa: arguments.isa.unwrap_or_else(cpu::best),
        reference: NamedQuality::EXHAUSTIVE
            .antialiased(arguments.antialias)
            .quality,
        size: arguments.size.unwrap_or(Size { width, height }),
        frames: arguments.frames.unwrap_or(frames),
        time_from: from,
        time_to: to,
        views: views(from, to, arguments.views, end),
        has_samples: arguments.ladder,
    })
}

fn measure(arguments: &Arguments, plan: &Plan, points: Vec<Point>) -> Trade {
    let threads = arguments::processors();
    let sizes = curves::sizes(plan.size, arguments.quick);
    let counts = curves::objects(arguments.quick);
    let mut steps = plan.steps(points.len());
    if !arguments.ladder {
        steps += sizes.iter().map(|&size| curves::cost(size, 1)).sum::<u64>();
        steps += counts.len() as u64 * curves::cost(plan.size, 2);
    }
    let bar = progress::bar(steps as usize);
    let progress = |done| bar.inc(done);
    let mut measurement = Measurement::new(plan, threads, &progress);
    let tallies = measurement.measure(points);
    let (mut by_resolution, mut by_objects) = (Vec::new(), Vec::new());
    if !arguments.ladder {
        let mut curves = Curves {
            scene: plan.scene,
            isa: plan.isa,
            size: plan.size,
            time: plan.time_from,
            qualities: curves::qualities(arguments.antialias),
            renderer: &mut measurement.timed,
            progress: &progress,
        };
        by_resolution = curves.by_resolution(&sizes);
        by_objects = curves.by_objects(counts);
    }
    bar.finish_and_clear();
    let area = plan.size.area();
    let mut rows: Vec<Outcome> = tallies
        .iter()
        .map(|tally| Outcome::of(tally, area))
        .collect();
    mark_front(&mut rows);
    Trade {
        machine: machine(),
        isa: plan.isa.name,
        scene: plan.scene.to_string(),
        width: plan.size.width,
        height: plan.size.height,
        times: (0..plan.frames)
            .map(|i| plan.time(i, plan.frames))
            .collect(),
        views: plan.views.iter().map(|view| view[0]).collect(),
        antialias: arguments.antialias,
        complete: !interrupt::is_stopped(),
        points: rows,
        by_resolution,
        by_objects,
    }
}

fn write(folder: &Path, trade: &Trade) -> Result<()> {
    let mut json = serde_json::to_vec_pretty(trade)?;
    json.push(b'\n');
    output::write(&folder.join("trade.json"), &json)?;
    plots::write(folder, trade)
}
