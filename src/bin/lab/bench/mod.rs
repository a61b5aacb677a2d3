//! `lab bench`: how fast frames are drawn, and how far they are from what tracing every pixel draws.

mod measure;
mod row;
mod table;

use crate::arguments::{self, NamedQuality, SceneName, Size};
use crate::isa::{self, Isa};
use crate::machine::machine;
use crate::{output, progress};
use anyhow::Result;
use clap::Args;
use measure::Plan;
use row::Row;
use std::path::{Path, PathBuf};
use std::thread::available_parallelism;

/// Measures how fast frames are drawn, and what that costs in accuracy
///
/// Prints a Markdown table. Exhaustive frames, every pixel traced, are always among those measured: the others are
/// held to them. What is compared takes turns, frame by frame. A frame's time holds making the scene and drawing it.
#[derive(Args)]
pub struct Arguments {
    /// The scene: model, or field:N for N small spheres
    #[arg(long, value_name = "NAME", default_value_t = SceneName::Model)]
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
    /// Frames to draw of each, at times spread evenly
    #[arg(long, value_name = "N", default_value = "101", value_parser = arguments::frames)]
    frames: usize,
    /// Time of the first frame in seconds
    #[arg(long, value_name = "SECONDS", default_value = "0", value_parser = arguments::seconds, allow_negative_numbers = true)]
    time_from: f32,
    /// Time of the last frame in seconds
    #[arg(long, value_name = "SECONDS", default_value = "10", value_parser = arguments::seconds, allow_negative_numbers = true)]
    time_to: f32,
    /// Frames in a row, 60 a second, in which flicker is counted
    #[arg(long, value_name = "N", default_value = "300", value_parser = arguments::frames)]
    flicker: usize,
    /// Instruction set [default: the best of this machine]
    #[arg(long, value_name = "NAME", value_parser = arguments::instruction_set)]
    isa: Option<Isa>,
    /// File to write the figures to as JSON, or - for standard output; the table then goes to standard error
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

/// Measures, and says how it went.
pub fn run(arguments: &Arguments) -> Result<()> {
    if let Some(file) = &arguments.json {
        output::check(file)?;
    }
    let plan = plan(arguments);
    let bar = progress::bar(plan.steps());
    let rows = plan.measure(|| bar.inc(1));
    bar.finish_and_clear();

    let table = format!(
        "{}; {} scene, {} frames from {} s to {} s\n\n{}",
        machine(),
        plan.scene,
        plan.frames,
        plan.time_from,
        plan.time_to,
        table::markdown(&rows)
    );
    match arguments.json.as_deref() {
        Some(file) if file == Path::new("-") => eprint!("{table}"),
        _ => output::write(Path::new("-"), table.as_bytes())?,
    }
    if let Some(file) = &arguments.json {
        output::write(file, &json(&rows)?)?;
    }
    Ok(())
}

fn plan(arguments: &Arguments) -> Plan {
    let mut threads = arguments.threads.clone();
    if threads.is_empty() {
        threads.push(available_parallelism().map_or(1, usize::from));
    }
    let others = arguments.quality.iter().copied();
    let qualities = [NamedQuality::EXHAUSTIVE].into_iter().chain(others);
    Plan {
        scene: arguments.scene,
        isa: arguments.isa.unwrap_or_else(isa::best),
        sizes: distinct(arguments.size.iter().copied()),
        threads: distinct(threads),
        qualities: distinct(qualities),
        frames: arguments.frames,
        time_from: arguments.time_from,
        time_to: arguments.time_to,
        flicker_frames: arguments.flicker,
    }
}

/// Each item the first time that it comes.
fn distinct<T: PartialEq>(items: impl IntoIterator<Item = T>) -> Vec<T> {
    let mut distinct = Vec::new();
    for item in items {
        if !distinct.contains(&item) {
            distinct.push(item);
        }
    }
    distinct
}

fn json(rows: &[Row]) -> Result<Vec<u8>> {
    let mut json = serde_json::to_vec_pretty(rows)?;
    json.push(b'\n');
    Ok(json)
}
