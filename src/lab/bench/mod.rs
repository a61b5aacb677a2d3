//! `lab bench`: how fast frames are drawn, and how far they are from what tracing every pixel draws.

mod row;
mod table;

use crate::arguments::{self, BadInput, NamedQuality, Size};
use crate::interrupt::{self, Stopped};
use crate::measure::{Plan, Shot};
use crate::output;
use crate::scenes::{self, SceneName};
use crate::timing::{evenly_spaced, machine};
use crate::views::views;
use crate::way::Way;
use anyhow::{Result, bail};
use clap::Args;
use eightfold_tracer::Quality;
use eightfold_window::cpu::{self, Isa};
use row::Row;
use std::path::{Path, PathBuf};

/// Measures how fast frames are drawn, and what that costs in accuracy
///
/// Prints a Markdown table. Exhaustive frames, every pixel traced, are always among those measured: the others are
/// held to them. What is compared takes turns, frame by frame. A frame's time holds making the scene, but for a scene file, and
/// drawing it. Ctrl-C prints and writes what has been measured so far.
///
/// The show has a line for each of its scenes, with the frames a second of its worst second, and one for the worst of the
/// whole show.
#[derive(Args)]
pub struct Arguments {
    #[arg(long, value_name = "NAME", default_value_t = SceneName::Model, help = scenes::takes())]
    scene: SceneName,
    /// Width and height in pixels; may be given several times
    #[arg(long, value_name = "WxH", default_value = "1024x768")]
    size: Vec<Size>,
    /// Threads that share the work; may be given several times [default: as many as there are processors]
    #[arg(long, value_name = "N", value_parser = arguments::threads)]
    threads: Vec<usize>,
    /// How frames are refined: exhaustive, thesis, or one of the ladder, from finest to fastest; may be given several times
    #[arg(long, value_name = "NAME", default_values = ["exhaustive", "thesis", "default"])]
    quality: Vec<NamedQuality>,
    /// Measures `unguarded` as well: the default quality that misses what lies between the corners of squares
    #[arg(long)]
    unguarded: bool,
    /// Measures each quality as well with lamps that have no size, whose shadows are hard: what penumbrae cost
    #[arg(long)]
    hard_shadows: bool,
    /// Leaves edges jagged; otherwise all frames are antialiased, the exhaustive ones too
    #[arg(long)]
    jagged: bool,
    /// Frames to draw of each quality and scene, at times spread evenly
    #[arg(long, value_name = "N", default_value = "101", value_parser = arguments::frames)]
    frames: usize,
    /// Time of the first frame in seconds, since the start of the scene or of the show
    #[arg(long, value_name = "SECONDS", default_value = "0", value_parser = arguments::seconds, allow_negative_numbers = true)]
    time_from: f32,
    /// Time of the last frame in seconds [default: 10, and in the show the last frame before the end]
    #[arg(long, value_name = "SECONDS", value_parser = arguments::seconds, allow_negative_numbers = true)]
    time_to: Option<f32>,
    /// Different views, spread evenly, at which FLIP and the distance to 64 samples a pixel are measured; pixels that pop are
    /// counted in the ten frames after each, 60 a second
    #[arg(long, value_name = "N", default_value = "9", value_parser = arguments::frames)]
    views: usize,
    /// Instruction set [default: the best of this machine]
    #[arg(long, value_name = "NAME", value_parser = arguments::instruction_set)]
    isa: Option<Isa>,
    /// File to write the figures to as JSON, or - for standard output; the table then goes to standard error
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

/// Seconds of a frame, at 60 a second.
const FRAME: f32 = 1.0 / 60.0;

/// Measures, and says how it went.
pub fn run(arguments: &Arguments) -> Result<()> {
    interrupt::listen();
    if let Some(file) = &arguments.json {
        output::check(file)?;
    }
    let plan = plan(arguments)?;
    let settings = plan.measure();
    let rows = settings.iter().flat_map(|setting| Row::of(&plan, setting));
    let rows: Vec<Row> = rows.collect();

    let (what, table) = match arguments.scene {
        SceneName::Show => ("show, each scene in", table::of_show(&rows)),
        scene => (&*format!("{scene} scene,"), table::of_scene(&rows)),
    };
    let (from, to) = times(arguments);
    let drawn = rows
        .iter()
        .map(|row| row.accuracy.frames)
        .max()
        .unwrap_or(0);
    let frames = if drawn < arguments.frames {
        format!("the first {drawn} of {}", arguments.frames)
    } else {
        drawn.to_string()
    };
    let table = format!(
        "{}; {what} {frames} frames from {from} s to {to} s\n\n{table}",
        machine()
    );
    match arguments.json.as_deref() {
        Some(file) if file == Path::new("-") => eprint!("{table}"),
        _ => output::write(Path::new("-"), table.as_bytes())?,
    }
    if let Some(file) = &arguments.json {
        output::write_json(file, &rows)?;
    }
    if interrupt::is_stopped() {
        bail!(Stopped("the table holds what was measured".to_owned()));
    }
    Ok(())
}

/// Times of the first and of the last frame in seconds.
fn times(arguments: &Arguments) -> (f32, f32) {
    let scene = arguments.scene;
    // The model scene's usual end is that of all measurements so far.
    let usual = scene.start().map_or(10.0, |_| scene.length() - FRAME);
    (arguments.time_from, arguments.time_to.unwrap_or(usual))
}

fn plan(arguments: &Arguments) -> Result<Plan> {
    arguments::check_span(arguments.time_from, arguments.time_to)?;
    let mut threads = arguments.threads.clone();
    if threads.is_empty() {
        threads.push(arguments::processors());
    }
    let others = arguments.quality.iter().copied();
    let unguarded = arguments.unguarded.then_some(NamedQuality {
        name: "unguarded",
        quality: Quality {
            guarded: false,
            ..Quality::DEFAULT
        },
    });
    let qualities = [NamedQuality::EXHAUSTIVE].into_iter().chain(others);
    let qualities = qualities.chain(unguarded);
    let ways = qualities.flat_map(|quality| {
        let shadows: &[bool] = if arguments.hard_shadows {
            &[false, true]
        } else {
            &[false]
        };
        shadows.iter().map(move |&hard_shadows| Way {
            name: format!("{quality}{}", if hard_shadows { ", hard" } else { "" }),
            quality: quality.antialiased(!arguments.jagged).quality,
            hard_shadows,
        })
    });
    let parts = arguments.scene.split().into_iter();
    let shots: Vec<Shot> = parts.filter_map(|part| shot(arguments, part)).collect();
    if shots.is_empty() {
        let scene = arguments.scene;
        bail!(BadInput(format!(
            "--time-from and --time-to take times in {scene}, 0 to {}",
            scene.length()
        )));
    }
    Ok(Plan {
        shots,
        isa: arguments.isa.unwrap_or_else(cpu::best),
        sizes: arguments::distinct(arguments.size.iter().copied()),
        threads: arguments::distinct(threads),
        ways: arguments::distinct(ways),
        is_on_processor: false,
        has_samples: true,
        has_missed: false,
    })
}

/// The frames of a scene; none if they would all lie outside of it.
fn shot(arguments: &Arguments, scene: SceneName) -> Option<Shot> {
    let (mut from, mut to) = times(arguments);
    if let Some(start) = scene.start() {
        // Between its cuts.
        let start = start - arguments.scene.start().unwrap_or(0.0);
        let last = scene.length() - FRAME;
        (from, to) = ((from - start).max(0.0), (to - start).min(last));
        if from > to {
            return None;
        }
    }
    let time = |frame: usize| evenly_spaced(from, to, frame, arguments.frames);
    // The next scene of the show has no part in this one.
    let end = scene.start().map(|_| scene.length());
    Some(Shot {
        scene,
        times: (0..arguments.frames).map(time).collect(),
        views: views(from, to, arguments.views, end),
    })
}
