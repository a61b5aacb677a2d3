//! The figures of a technique in a setting, and tables of them.

use crate::error::Difference;
use crate::markdown::{self, Column, dash, decibels, known, percent};
use crate::measure::{Plan, Run, Setting, Shot, Technique};
use crate::rivals::Way;
use crate::timing::{median, percentile};
use eightfold_tracer::Quality;
use serde::Serialize;

/// The figures of a technique in a setting.
///
/// Times are in milliseconds, counts are means of a frame, shares are of 1. `null` in JSON is a PSNR without any error, or a figure
/// that was not measured.
#[derive(Clone, Serialize)]
pub struct Row {
    pub scene: String,
    pub width: usize,
    pub height: usize,
    pub threads: usize,
    pub isa: &'static str,
    #[serde(rename = "quality")]
    pub name: String,
    #[serde(skip)]
    pub quality: Quality,
    #[serde(skip)]
    pub way: Way,
    pub frames: usize,
    pub fps_median: f64,
    /// In the second of the scene, or of the show, whose frames took longest.
    pub fps_worst_second: f64,
    pub ms_median: f64,
    /// 99 of 100 frames took no longer.
    pub ms_p99: f64,
    /// The first quartile of the reference's times over this one's: others at work on the machine lengthen the slower frames.
    pub speedup: f64,
    /// Points traced per pixel.
    pub traced_fraction: f64,
    /// Primary and secondary rays.
    pub rays: f64,
    pub shadow_rays: f64,
    /// Primary and secondary rays for each lane that could have carried one.
    pub lane_occupancy: f64,
    /// The PSNR of all frames together against the reference.
    pub psnr_db: f64,
    pub psnr_worst_db: f64,
    /// Pixels with a channel more than 8 of 255 off.
    pub pixels_over_8: f64,
    /// See [`crate::seen`].
    pub pops: Option<f64>,
    pub flip_mean: Option<f64>,
    pub missed_objects: Option<f64>,
    pub psnr_to_64_db: Option<f64>,
    pub flip_to_64: Option<f64>,
    /// Whether it is on the Pareto front, see [`crate::trade`].
    pub on_front: bool,
}

impl Row {
    /// Returns the rows of a setting, one for each technique.
    pub fn of(plan: &Plan, setting: &Setting) -> Vec<Self> {
        let runs = setting.runs.iter().zip(&plan.techniques);
        let reference = quartile(&setting.runs[0]);
        let shot = &plan.shots[setting.shot];
        let row = |(run, technique): (&Run, &Technique)| {
            let frames = run.times.len();
            let per_frame = |count: u64| count as f64 / frames as f64;
            let psnr = run.differences.iter().map(|difference| difference.psnr);
            let over_8: usize = run.differences.iter().map(|each| each.over_8).sum();
            let ms = median(&run.times);
            Self {
                scene: shot.scene.to_string(),
                width: setting.size.width,
                height: setting.size.height,
                threads: setting.threads,
                isa: plan.isa.name,
                name: technique.name.clone(),
                quality: technique.quality,
                way: technique.way,
                frames,
                fps_median: 1e3 / ms,
                fps_worst_second: 1e3 / worst_second(shot, &run.times),
                ms_median: ms,
                ms_p99: percentile(&run.times, 99),
                speedup: reference / quartile(run),
                traced_fraction: per_frame(run.counts.points) / setting.size.area() as f64,
                rays: per_frame(run.counts.rays),
                shadow_rays: per_frame(run.counts.shadow_rays),
                lane_occupancy: run.counts.rays as f64 / run.counts.lanes as f64,
                psnr_db: Difference::pooled_psnr(&run.differences),
                psnr_worst_db: psnr.fold(f64::INFINITY, f64::min),
                pixels_over_8: per_frame(over_8 as u64),
                pops: run.seen.pops(),
                flip_mean: run.seen.flips.mean(),
                missed_objects: run.seen.missed(),
                psnr_to_64_db: run.seen.psnr_to_64_db(),
                flip_to_64: run.seen.flips_to_64.mean(),
                on_front: false,
            }
        };
        runs.map(row).collect()
    }

    /// Whether all frames equal the reference's.
    pub fn is_exact(&self) -> bool {
        self.psnr_db.is_infinite()
    }
}

/// Returns the first quartile of the times of a run.
pub fn quartile(run: &Run) -> f64 {
    percentile(&run.times, 25)
}

/// Returns the mean time of the frames in the second that took longest, of the show or of a scene that stands alone.
fn worst_second(shot: &Shot, times: &[f64]) -> f64 {
    let start = shot.scene.start().unwrap_or(0.0);
    let seconds = shot.times.iter().map(|time| (start + time).floor());
    let frames: Vec<(f32, f64)> = seconds.zip(times.iter().copied()).collect();
    let means = frames.chunk_by(|a, b| a.0 == b.0).map(|second| {
        let sum: f64 = second.iter().map(|(_, ms)| ms).sum();
        sum / second.len() as f64
    });
    means.fold(0.0, f64::max)
}

/// The columns of all tables.
const COLUMNS: [Column<Row>; 20] = [
    ("size", |row| format!("{}x{}", row.width, row.height)),
    ("threads", |row| row.threads.to_string()),
    ("scene", |row| row.scene.clone()),
    ("quality", |row| row.name.clone()),
    ("fps median", |row| format!("{:.1}", row.fps_median)),
    ("worst second", |row| format!("{:.1}", row.fps_worst_second)),
    ("ms median", |row| format!("{:.3}", row.ms_median)),
    ("ms p99", |row| format!("{:.3}", row.ms_p99)),
    ("speed-up", |row| format!("{:.2}", row.speedup)),
    ("traced", |row| percent(row.traced_fraction)),
    ("rays", |row| format!("{:.0}", row.rays)),
    ("shadow rays", |row| format!("{:.0}", row.shadow_rays)),
    ("PSNR", |row| decibels(row.psnr_db)),
    ("PSNR worst", |row| decibels(row.psnr_worst_db)),
    ("over 8/255", |row| format!("{:.1}", row.pixels_over_8)),
    ("pops", |row| known(row.pops, 1)),
    ("FLIP", |row| known(row.flip_mean, 4)),
    ("missed", |row| known(row.missed_objects, 2)),
    ("PSNR to 64", |row| {
        row.psnr_to_64_db.map_or_else(dash, decibels)
    }),
    ("FLIP to 64", |row| known(row.flip_to_64, 4)),
];

/// The titles of the columns of errors.
const ERRORS: &str = "PSNR, PSNR worst, over 8/255, pops, FLIP, PSNR to 64, FLIP to 64";

/// Returns a Markdown table with columns of these titles and the columns of errors.
pub fn table<'a>(titles: &str, rows: impl IntoIterator<Item = &'a Row> + Clone) -> String {
    let titles = titles.split(", ").chain(ERRORS.split(", "));
    let column = |title| COLUMNS.into_iter().find(|column| column.0 == title);
    let columns: Vec<Column<Row>> = titles
        .map(|title| column(title).expect("a column"))
        .collect();
    markdown::table(&columns, rows)
}

/// A quality against what people do in the same time.
struct Race {
    own: Row,
    /// The enlarged frame that takes as long: its scale and its PSNR to 64 samples.
    enlarged: [f64; 2],
    checkerboard: Option<Row>,
}

const RACES: [Column<Race>; 8] = [
    ("scene", |race| race.own.scene.clone()),
    ("quality", |race| race.own.name.clone()),
    ("speed-up", |race| format!("{:.2}", race.own.speedup)),
    ("PSNR to 64", |race| decibels(psnr_to_64(&race.own))),
    ("resolution", |race| format!("{:.2}", race.enlarged[0])),
    ("its PSNR", |race| decibels(race.enlarged[1])),
    ("ahead by", |race| {
        decibels(psnr_to_64(&race.own) - race.enlarged[1])
    }),
    ("checkerboard", |race| {
        race.checkerboard.as_ref().map_or_else(dash, |row| {
            format!("{:.2}, {}", row.speedup, decibels(psnr_to_64(row)))
        })
    }),
];

fn psnr_to_64(row: &Row) -> f64 {
    row.psnr_to_64_db.unwrap_or(f64::NAN)
}

/// Returns a Markdown table that compares qualities with enlarged frames that take the same time, and with the checkerboard. An
/// enlarged frame between two that were measured is interpolated; where the smallest is slower, it is taken.
pub fn races(rows: &[Row]) -> String {
    let setting = |row: &Row| (row.scene.clone(), row.width, row.height, row.threads);
    let settings = rows.chunk_by(|a, b| setting(a) == setting(b));
    let mut races = Vec::new();
    for rows in settings {
        let frame = |row: &Row| {
            let scale = match row.way {
                Way::Enlarged(scale) => Some(scale),
                _ => row.is_exact().then_some(1.0),
            };
            scale.map(|scale| [row.speedup, scale, psnr_to_64(row)])
        };
        let mut frames: Vec<[f64; 3]> = rows.iter().filter_map(frame).collect();
        frames.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let checkerboard = rows.iter().find(|row| row.way == Way::Checkerboard);
        let qualities = rows.iter();
        let qualities = qualities.filter(|row| row.way == Way::Drawn && !row.is_exact());
        races.extend(qualities.map(|own| Race {
            own: own.clone(),
            enlarged: at_speed(&frames, own.speedup),
            checkerboard: checkerboard.cloned(),
        }));
    }
    markdown::table(&RACES, &races)
}

/// Interpolates points in the order of their speed-ups, each of which has two figures; beyond the ends they stay.
fn at_speed(points: &[[f64; 3]], speedup: f64) -> [f64; 2] {
    let last = points.len() - 1;
    let next = points.iter().position(|point| point[0] >= speedup);
    let next = next.unwrap_or(last);
    let (a, b) = (points[next.saturating_sub(1)], points[next]);
    let share = if next == 0 {
        1.0
    } else {
        ((speedup - a[0]) / (b[0] - a[0])).min(1.0)
    };
    [1, 2].map(|i| a[i] + share * (b[i] - a[i]))
}
