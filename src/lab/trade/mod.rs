//! `lab trade`: measures the gain in speed and the cost in accuracy of each dial of the quality.

mod curves;
mod front;
mod plots;
mod sweep;

use crate::arguments::{self, NamedQuality, Size};
use crate::interrupt::{self, Stopped};
use crate::measure::{Plan, Shot, Technique};
use crate::output;
use crate::rivals::Way;
use crate::row::{self, Row};
use crate::scenes::{self, SceneName};
use crate::timing::machine;
use anyhow::{Context, Result, ensure};
use clap::Args;
use curves::Curve;
use eightfold_window::cpu::{self, Isa};
use serde::Serialize;
use std::fs;
use std::path::{Path, PathBuf};

/// Measures the gain in speed and the cost in accuracy of each dial of the quality
///
/// Writes trade.json and plots as SVG into a folder, and prints a Markdown table of the Pareto front. A setting is on the front if it
/// compares colours, objects and lights, misses no object, and no other such setting is better in speed, FLIP and pops at once.
/// Speed is a ratio to exhaustive frames, every pixel traced, by one thread; errors are against the same frames. Frames of fewer
/// pixels are measured beside them: exhaustive ones enlarged, `resolution:0.4` to `0.9` of their sides, and a `checkerboard`, every
/// second pixel traced. Ctrl-C writes the figures so far.
///
/// The dials are fields of the library's `Quality`. `tolerance` is that within which colours fill a square, also of midpoints of
/// sides; `keys` are the depths of objects and of lights' states that are compared; `contribution` is the least of a ray.
#[derive(Args)]
pub struct Arguments {
    #[arg(long, value_name = "NAME", default_value_t = SceneName::Model, help = scenes::takes())]
    scene: SceneName,
    /// Width and height in pixels
    #[arg(long, value_name = "WxH", default_value = "1024x768")]
    size: Size,
    /// Antialiases the edges of all frames, the exhaustive ones too; otherwise no frame is antialiased
    #[arg(long)]
    antialias: bool,
    /// Frames of each setting against the clock, at times spread evenly
    #[arg(long, value_name = "N", default_value = "51", value_parser = arguments::frames)]
    frames: usize,
    /// Views, spread evenly, at which FLIP, missed objects and the distance to 64 samples per pixel are measured; pops are counted in
    /// the ten frames after each, 60 per second
    #[arg(long, value_name = "N", default_value = "9", value_parser = arguments::frames)]
    views: usize,
    /// Instruction set [default: the best of this machine]
    #[arg(long, value_name = "NAME", value_parser = arguments::instruction_set)]
    isa: Option<Isa>,
    /// Measures the named qualities alone, and writes no files
    #[arg(long)]
    ladder: bool,
    /// Folder to write to; it is made where it is missing
    #[arg(long, value_name = "FOLDER", default_value = "target/trade")]
    out: PathBuf,
}

/// All results, as they are written to JSON.
#[derive(Serialize)]
struct Trade {
    /// The machine, the scene and the settings in words.
    heading: String,
    rows: Vec<Row>,
    by_resolution: Vec<Curve>,
    by_spheres: Vec<Curve>,
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> Result<()> {
    interrupt::listen();
    let folder = &arguments.out;
    if !arguments.ladder {
        fs::create_dir_all(folder).with_context(|| format!("cannot make {}", folder.display()))?;
        output::check(&folder.join("trade.json"))?;
    }
    let plan = plan(arguments);
    let mut rows = Row::of(&plan, &plan.measure()[0]);
    front::mark(&mut rows);
    let heading = format!(
        "{}, {}; {}, {}, {} edges, {} frames",
        machine(),
        plan.isa.name,
        arguments.scene,
        arguments.size,
        if arguments.antialias {
            "antialiased"
        } else {
            "jagged"
        },
        rows[0].frames
    );
    const TITLES: &str = "quality, speed-up, traced, missed";
    let table = if arguments.ladder {
        row::table(TITLES, &rows)
    } else {
        row::table(TITLES, front::from_the_slowest(&rows))
    };
    output::write(Path::new("-"), format!("{heading}\n\n{table}").as_bytes())?;
    if !arguments.ladder {
        let trade = Trade {
            heading,
            rows,
            by_resolution: curves::by_resolution(&plan),
            by_spheres: curves::by_spheres(&plan),
        };
        output::write_json(&folder.join("trade.json"), &trade)?;
        plots::write(folder, &trade)?;
    }
    let stopped = Stopped("the table has the figures so far".to_owned());
    ensure!(!interrupt::is_stopped(), stopped);
    Ok(())
}

fn plan(arguments: &Arguments) -> Plan {
    let named = NamedQuality::all();
    let mut techniques: Vec<Technique> = if arguments.ladder {
        named.map(|named| Technique::named(named, false)).collect()
    } else {
        sweep::techniques()
    };
    for technique in &mut techniques {
        technique.quality.antialias = arguments.antialias;
    }
    if !arguments.ladder {
        let rivals = Technique::rivals(arguments.antialias);
        techniques.extend(rivals.filter(|rival| rival.way != Way::Drawn));
    }
    Plan {
        shots: vec![Shot::new(
            arguments.scene,
            arguments.frames,
            arguments.views,
        )],
        isa: arguments.isa.unwrap_or_else(cpu::best),
        sizes: vec![arguments.size],
        threads: vec![1],
        techniques,
    }
}
