use super::{Trade, from_the_slowest};
use crate::measure::{Measurement, Setting, Shot};
use crate::plot::{Chart, Series};
use crate::row::{Row, quartile};
use crate::scenes::SceneName;
use crate::technique::{Sampling, Technique};
use crate::{interrupt, output};
use anyhow::Result;
use eightfold_harness::Size;
use eightfold_tracer::scene::MAX_SPHERES;
use eightfold_tracer::{MAX_HEIGHT, MAX_WIDTH, Preset, Quality};
use plotters::chart::SeriesLabelPosition::{self, *};
use serde::Serialize;
use std::path::Path;

const PSNR: &str = "dB to exhaustive";
const SPEED_UP: &str = "speed-up over exhaustive frames";

pub fn write(folder: &Path, trade: &Trade) -> Result<()> {
    let resolution = curves(&trade.by_resolution, "pixels of the picture", UpperLeft);
    let objects = curves(&trade.by_spheres, "small spheres", UpperRight);
    for (name, chart) in [
        ("front", front(trade)),
        ("squares", squares(trade)),
        ("resolution", resolution),
        ("objects", objects),
    ] {
        if !chart.series.is_empty() {
            let svg = chart.svg(&trade.heading)?;
            output::write(&folder.join(format!("{name}.svg")), svg.as_bytes())?;
        }
    }
    Ok(())
}

fn front(trade: &Trade) -> Chart {
    let is_named = |row: &&Row| row.name.parse::<Preset>().is_ok();
    let dots = |name: &str, rows: Vec<&Row>, has_labels: bool| {
        let labels = rows.iter().filter(|_| has_labels);
        Series {
            name: name.to_owned(),
            points: rows.iter().map(|row| (row.speedup, row.psnr_db)).collect(),
            labels: labels.map(|row| row.name.clone()).collect(),
            has_line: false,
        }
    };
    let is_rival = |row: &&Row| row.sampling != Sampling::Full;
    let inexact = trade.rows.iter().filter(|row| !row.is_exact());
    let (rivals, settings): (Vec<&Row>, Vec<&Row>) = inexact.partition(is_rival);
    let named = settings.iter().copied().filter(is_named).collect();
    Chart {
        x: SPEED_UP,
        y: PSNR,
        legend: LowerLeft,
        series: vec![
            dots("settings", settings, false),
            dots("Pareto front", from_the_slowest(&trade.rows), false),
            dots("named", named, true),
            dots("fewer pixels", rivals, true),
        ],
    }
}

/// The labels are speed-ups.
fn squares(trade: &Trade) -> Chart {
    let series = |(name, base): (&str, Quality)| {
        let is_varied = |row: &&Row| {
            let square = row.quality.square;
            square > 1 && row.quality == Quality { square, ..base.jagged() }
        };
        let mut rows: Vec<&Row> = trade.rows.iter().filter(is_varied).collect();
        rows.sort_by_key(|row| row.quality.square);
        let point = |row: &&Row| (row.quality.square as f64, row.psnr_db);
        let label = |row: &&Row| format!("{:.1}x", row.speedup);
        Series {
            name: name.to_owned(),
            points: rows.iter().map(point).collect(),
            labels: rows.iter().map(label).collect(),
            has_line: true,
        }
    };
    let bases = [("thesis", Quality::THESIS), ("default", Quality::DEFAULT)];
    Chart {
        x: "side of the largest square, pixels",
        y: PSNR,
        legend: MiddleRight,
        series: bases.into_iter().map(series).collect(),
    }
}

fn curves(curves: &[Curve], x: &'static str, legend: SeriesLabelPosition) -> Chart {
    let series = curves.iter().map(|curve| Series {
        name: curve.name.clone(),
        points: curve.points.clone(),
        labels: Vec::new(),
        has_line: true,
    });
    Chart { x, y: SPEED_UP, legend, series: series.collect() }
}

/// Repetitions of a frame.
const FRAMES: usize = 7;
/// Relative to `--size`.
const SCALES: [f64; 5] = [0.25, 0.5, 1.0, 2.0, 2.8];
const SPHERES: [usize; 10] = [1, 2, 4, 8, 16, 32, 64, 128, 256, MAX_SPHERES];
/// The reference first.
const PRESETS: [Preset; 5] =
    [Preset::Exhaustive, Preset::Thesis, Preset::Finest, Preset::Default, Preset::Fastest];

#[derive(Serialize)]
pub struct Curve {
    pub name: String,
    /// Number of pixels or spheres, and speed-up.
    pub points: Vec<(f64, f64)>,
}

pub fn by_resolution(of: &Measurement) -> Vec<Curve> {
    let sizes = SCALES.into_iter().map(|scale| of.sizes[0].scaled(scale));
    let fits = |size: &Size| size.width <= MAX_WIDTH && size.height <= MAX_HEIGHT;
    let sizes = sizes.filter(fits).collect();
    measured(of, &[of.shots[0].scene], sizes, |setting| setting.size.area())
}

pub fn by_spheres(of: &Measurement) -> Vec<Curve> {
    let fields = SPHERES.map(SceneName::Field);
    measured(of, &fields, of.sizes.clone(), |setting| SPHERES[setting.shot])
}

/// Measures the first frame of each scene. Returns no curves after Ctrl-C.
fn measured(
    of: &Measurement,
    scenes: &[SceneName],
    sizes: Vec<Size>,
    x: impl Fn(&Setting) -> usize,
) -> Vec<Curve> {
    if interrupt::is_stopped() {
        return Vec::new();
    }
    let shots =
        scenes.iter().map(|&scene| Shot { scene, times: vec![0.0; FRAMES], views: Vec::new() });
    let measurement = Measurement {
        shots: shots.collect(),
        isa: of.isa,
        sizes,
        threads: vec![1],
        techniques: PRESETS.map(|preset| Technique::named(preset, false)).to_vec(),
    };
    let settings = measurement.run();
    let curve = |i: usize| {
        let speed_up = |setting: &Setting| quartile(&setting.runs[0]) / quartile(&setting.runs[i]);
        let point = |setting| (x(setting) as f64, speed_up(setting));
        Curve { name: PRESETS[i].to_string(), points: settings.iter().map(point).collect() }
    };
    (1..PRESETS.len()).map(curve).collect()
}
