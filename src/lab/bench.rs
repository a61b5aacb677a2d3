use crate::arguments::{self, distinct, within};
use crate::measure::{Measurement, Shot, ShotArguments, Technique};
use crate::row::{self, Row, machine};
use crate::scenes::SceneName;
use crate::{interrupt, output};
use anyhow::Result;
use clap::Args;
use eightfold_harness::Size;
use eightfold_tracer::Preset;
use eightfold_window::cpu;
use std::path::{Path, PathBuf};

/// Measures the speed and the error of frames
///
/// Prints a Markdown table with a row per setting and scene, relative to exhaustive frames. Ctrl-C
/// prints the figures so far.
#[derive(Args)]
pub struct Arguments {
    #[command(flatten)]
    shot: ShotArguments,
    /// Width and height in pixels; repeatable
    #[arg(long, value_name = "WxH", default_value = "1024x768")]
    size: Vec<Size>,
    /// Threads; repeatable [default: the number of processors]
    #[arg(long, value_name = "N", value_parser = within(arguments::THREADS))]
    threads: Vec<usize>,
    #[arg(long, value_name = "NAME", default_values = ["exhaustive", "thesis", "default"], help = format!("{}; repeatable", arguments::QUALITY))]
    quality: Vec<Preset>,
    /// Draws all frames with jagged edges; by default all but the checkerboard are antialiased
    #[arg(long)]
    jagged: bool,
    /// Compares with rivals instead: prints by how many dB (to 64 samples) each quality beats a
    /// smaller, enlarged frame of equal time, and the figures of a checkerboard. Adds `default`
    /// without its guard
    #[arg(long)]
    rivals: bool,
    /// Frames of each setting, at even intervals
    #[arg(long, value_name = "N", default_value = "101", value_parser = within(arguments::FRAMES))]
    frames: usize,
    /// JSON file for the figures of all frames, or - for standard output; the table then goes to
    /// standard error
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

pub fn run(arguments: &Arguments) -> Result<()> {
    interrupt::listen();
    if let Some(file) = &arguments.json {
        output::check(file)?;
    }
    let scene = arguments.shot.scene;
    let measurement = measurement(arguments);
    let settings = measurement.run();
    let rows: Vec<Row> = settings.iter().flat_map(|it| Row::of(&measurement, it)).collect();
    let titles = if scene == SceneName::Show {
        "size, threads, scene, quality, fps median, worst second, ms p99, speed-up, traced"
    } else {
        "size, threads, quality, ms median, ms p99, speed-up, traced, rays"
    };
    let is_asked = |row: &&Row| arguments.quality.iter().any(|it| it.name() == row.name);
    let table = format!(
        "{}, {}; {scene}, {} frames per scene\n\n{}",
        machine(),
        measurement.isa.name,
        rows.iter().map(|row| row.frames).max().unwrap_or(0),
        if arguments.rivals {
            row::races(&rows)
        } else {
            row::table(titles, rows.iter().filter(is_asked))
        }
    );
    match arguments.json.as_deref() {
        Some(file) if file == Path::new("-") => eprint!("{table}"),
        _ => output::write(Path::new("-"), table.as_bytes())?,
    }
    if let Some(file) = &arguments.json {
        output::write_json(file, &rows)?;
    }
    Ok(interrupt::check("the table is incomplete")?)
}

fn measurement(arguments: &Arguments) -> Measurement {
    let mut threads = arguments.threads.clone();
    if threads.is_empty() {
        threads.push(arguments::processors());
    }
    let qualities = [Preset::Exhaustive].into_iter().chain(arguments.quality.iter().copied());
    let antialias = !arguments.jagged;
    let techniques = qualities.map(|quality| Technique::named(quality, antialias));
    let rivals = Technique::rivals(antialias).filter(|_| arguments.rivals);
    let ShotArguments { scene, views, isa } = arguments.shot;
    let shot = |scene| Shot::new(scene, arguments.frames, views);
    Measurement {
        shots: scene.split().into_iter().map(shot).collect(),
        isa: isa.unwrap_or_else(cpu::best),
        sizes: distinct(arguments.size.iter().copied()),
        threads: distinct(threads),
        techniques: distinct(techniques.chain(rivals)),
    }
}
