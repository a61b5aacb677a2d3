//! `cargo lab trade`: speed against accuracy, as plots.

mod plots;
mod sweep;

use crate::arguments::{self, within};
use crate::measure::{Measurement, Shot, ShotArguments};
use crate::row::{self, Row, machine};
use crate::technique::{Sampling, Technique};
use crate::{interrupt, output};
use anyhow::{Context, Result};
use clap::Args;
use eightfold_harness::Size;
use eightfold_tracer::Preset;
use eightfold_window::cpu;
use plots::Curve;
use serde::Serialize;
use std::fs;
use std::path::{Path, PathBuf};

/// Measures the gain in speed and the cost in accuracy of the fields of `Quality`
///
/// Writes trade.json and SVG plots. Prints a Markdown table of the Pareto front in speed, FLIP and
/// pops, of the settings that compare colours, objects and lights, relative to exhaustive frames on
/// one thread. Also measures frames enlarged from 0.3 to 0.9 of the width, and a checkerboard of
/// traced pixels. Ctrl-C writes the figures so far.
///
/// `tolerance` is for the colours of squares and of midpoints of sides; `keys` are the depths of
/// compared objects and lights' states; `contribution` is the smallest weight of a ray.
#[derive(Args)]
pub struct Arguments {
    #[command(flatten)]
    shot: ShotArguments,
    /// Width and height in pixels
    #[arg(long, value_name = "WxH", default_value = "1024x768")]
    size: Size,
    /// Timed frames of each setting, at even intervals
    #[arg(long, value_name = "N", default_value = "51", value_parser = within(arguments::FRAMES))]
    frames: usize,
    /// Measures only named qualities, and writes no files
    #[arg(long)]
    ladder: bool,
    /// Folder to write to
    #[arg(long, value_name = "FOLDER", default_value = "target/trade")]
    out: PathBuf,
}

#[derive(Serialize)]
struct Trade {
    heading: String,
    rows: Vec<Row>,
    by_resolution: Vec<Curve>,
    by_spheres: Vec<Curve>,
}

pub fn run(arguments: &Arguments) -> Result<()> {
    interrupt::listen();
    let folder = &arguments.out;
    if !arguments.ladder {
        fs::create_dir_all(folder).with_context(|| output::cannot("make", folder))?;
        output::check(&folder.join("trade.json"))?;
    }
    let measurement = measurement(arguments);
    let mut rows = Row::of(&measurement, &measurement.run()[0]);
    mark_front(&mut rows);
    let heading = format!(
        "{}, {}; {}, {}, jagged edges, {} frames",
        machine(),
        measurement.isa.name,
        arguments.shot.scene,
        arguments.size,
        rows[0].frames
    );
    let listed = if arguments.ladder { rows.iter().collect() } else { from_the_slowest(&rows) };
    let table = row::table("quality, speed-up, traced", listed);
    output::write(Path::new("-"), format!("{heading}\n\n{table}").as_bytes())?;
    if !arguments.ladder {
        let trade = Trade {
            heading,
            rows,
            by_resolution: plots::by_resolution(&measurement),
            by_spheres: plots::by_spheres(&measurement),
        };
        output::write_json(&folder.join("trade.json"), &trade)?;
        plots::write(folder, &trade)?;
    }
    Ok(interrupt::check("the table is incomplete")?)
}

fn measurement(arguments: &Arguments) -> Measurement {
    let techniques = if arguments.ladder {
        Preset::ALL.map(|preset| Technique::named(preset, false)).to_vec()
    } else {
        let rivals = Technique::rivals(false);
        let rivals = rivals.filter(|rival| rival.sampling != Sampling::Full);
        sweep::techniques().into_iter().chain(rivals).collect()
    };
    let ShotArguments { scene, views, isa } = arguments.shot;
    Measurement {
        shots: vec![Shot::new(scene, arguments.frames, views)],
        isa: isa.unwrap_or_else(cpu::best),
        sizes: vec![arguments.size],
        threads: vec![1],
        techniques,
    }
}

/// Marks the Pareto front of allowed rows in speed, FLIP and pops. After Ctrl-C, PSNR replaces FLIP
/// and pops.
fn mark_front(rows: &mut [Row]) {
    let costs = |row: &Row| match (row.flip_mean, row.pops) {
        (Some(flip), Some(pops)) => [-row.speedup, flip, pops],
        _ => [-row.speedup, -row.psnr_db, 0.0],
    };
    let all = rows.iter().filter(|row| is_allowed(row)).map(costs);
    let all: Vec<[f64; 3]> = all.collect();
    for row in rows {
        let own = costs(row);
        let beats = |other: &[f64; 3]| *other != own && (0..3).all(|i| other[i] <= own[i]);
        row.on_front = is_allowed(row) && !all.iter().any(beats);
    }
}

fn from_the_slowest(rows: &[Row]) -> Vec<&Row> {
    let on_front = |row: &&Row| row.on_front && !row.is_exact();
    let mut front: Vec<&Row> = rows.iter().filter(on_front).collect();
    front.sort_by(|a, b| a.speedup.total_cmp(&b.speedup));
    front
}

/// Requires a guard, and comparisons of colours, objects and lights.
fn is_allowed(row: &Row) -> bool {
    let quality = &row.quality;
    let compares_keys = quality.tolerance_differing == 0.0 && quality.tolerance_agreeing != 0.0;
    let has_rules = quality.guarded && (compares_keys || quality.square == 1);
    row.sampling == Sampling::Full && has_rules
}
