//! `lab bench`: measures the speed of frames, and their error against frames with every pixel traced.

use crate::arguments::{self, NamedQuality, Size, distinct};
use crate::interrupt::{self, Stopped};
use crate::measure::{Plan, Shot, Technique};
use crate::output;
use crate::row::{self, Row};
use crate::scenes::{self, SceneName};
use crate::timing::machine;
use anyhow::{Result, ensure};
use clap::Args;
use eightfold_window::cpu::{self, Isa};
use std::path::{Path, PathBuf};

/// Measures the speed and the error of frames
///
/// Prints a Markdown table. Exhaustive frames, every pixel traced, are always measured: the others are compared with them. Settings
/// take turns, frame by frame. By one thread a frame's time is the thread's on a processor. Ctrl-C prints and writes the figures so
/// far. The show has rows for each of its scenes.
#[derive(Args)]
pub struct Arguments {
    #[arg(long, value_name = "NAME", default_value_t = SceneName::Model, help = scenes::takes())]
    scene: SceneName,
    /// Width and height in pixels; may be given several times
    #[arg(long, value_name = "WxH", default_value = "1024x768")]
    size: Vec<Size>,
    /// Threads that share the work; may be given several times [default: the number of processors]
    #[arg(long, value_name = "N", value_parser = arguments::threads)]
    threads: Vec<usize>,
    /// How frames are refined: exhaustive, thesis, or one of the ladder, from finest to fastest; may be given several times
    #[arg(long, value_name = "NAME", default_values = ["exhaustive", "thesis", "default"])]
    quality: Vec<NamedQuality>,
    /// Leaves edges jagged; otherwise all frames are antialiased, the exhaustive ones too
    #[arg(long)]
    jagged: bool,
    /// Measures what people do instead, too, and prints a table of what a quality is ahead by in the same time: exhaustive frames of
    /// 0.4 to 0.9 of the sides, enlarged; a checkerboard, every second pixel traced; and the default quality without its guard
    #[arg(long)]
    rivals: bool,
    /// Frames of each quality and scene, at times spread evenly
    #[arg(long, value_name = "N", default_value = "101", value_parser = arguments::frames)]
    frames: usize,
    /// Views, spread evenly, at which FLIP, missed objects and the distance to 64 samples per pixel are measured; pops are counted in
    /// the ten frames after each, 60 per second
    #[arg(long, value_name = "N", default_value = "9", value_parser = arguments::frames)]
    views: usize,
    /// Instruction set [default: the best of this machine]
    #[arg(long, value_name = "NAME", value_parser = arguments::instruction_set)]
    isa: Option<Isa>,
    /// File for the figures as JSON, or - for standard output; the table then goes to standard error
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> Result<()> {
    interrupt::listen();
    if let Some(file) = &arguments.json {
        output::check(file)?;
    }
    let plan = plan(arguments);
    let settings = plan.measure();
    let rows = settings.iter().flat_map(|setting| Row::of(&plan, setting));
    let rows: Vec<Row> = rows.collect();
    let titles = if arguments.scene == SceneName::Show {
        "size, threads, scene, quality, fps median, worst second, ms median, ms p99, speed-up, traced"
    } else {
        "size, threads, quality, fps median, ms median, ms p99, speed-up, traced, rays, shadow rays"
    };
    let races = if arguments.rivals {
        format!("\n{}", row::races(&rows))
    } else {
        String::new()
    };
    let table = format!(
        "{}, {}; {}, {} frames per scene\n\n{}{races}",
        machine(),
        plan.isa.name,
        arguments.scene,
        rows.iter().map(|row| row.frames).max().unwrap_or(0),
        row::table(titles, &rows)
    );
    match arguments.json.as_deref() {
        Some(file) if file == Path::new("-") => eprint!("{table}"),
        _ => output::write(Path::new("-"), table.as_bytes())?,
    }
    if let Some(file) = &arguments.json {
        output::write_json(file, &rows)?;
    }
    let stopped = Stopped("the table has the figures so far".to_owned());
    ensure!(!interrupt::is_stopped(), stopped);
    Ok(())
}

fn plan(arguments: &Arguments) -> Plan {
    let mut threads = arguments.threads.clone();
    if threads.is_empty() {
        threads.push(arguments::processors());
    }
    let qualities = [NamedQuality::EXHAUSTIVE].into_iter();
    let qualities = qualities.chain(arguments.quality.iter().copied());
    let antialias = !arguments.jagged;
    let techniques = qualities.map(|quality| Technique::named(quality, antialias));
    let rivals = Technique::rivals(antialias).filter(|_| arguments.rivals);
    let shot = |scene| Shot::new(scene, arguments.frames, arguments.views);
    Plan {
        shots: arguments.scene.split().into_iter().map(shot).collect(),
        isa: arguments.isa.unwrap_or_else(cpu::best),
        sizes: distinct(arguments.size.iter().copied()),
        threads: distinct(threads),
        techniques: distinct(techniques.chain(rivals)),
    }
}
