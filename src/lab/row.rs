use crate::arguments::processors;
use crate::measure::{Measurement, Run, Sampling, Setting, Shot, Technique};
use eightfold_harness::error::Difference;
use eightfold_tracer::Quality;
use serde::Serialize;
use std::fs;

/// Counts are means per frame. `null` in JSON is unknown, or the PSNR of equal pictures.
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
    pub sampling: Sampling,
    pub frames: usize,
    pub fps_median: f64,
    pub fps_worst_second: f64,
    pub ms_median: f64,
    pub ms_p99: f64,
    /// The reference's first quartile of times, divided by this row's: other programs lengthen
    /// slower frames.
    pub speedup: f64,
    pub traced_fraction: f64,
    /// Primary and secondary rays.
    pub rays: f64,
    pub shadow_rays: f64,
    /// Rays per lane of their packets.
    pub lane_occupancy: f64,
    /// Of all frames together, to exhaustive ones.
    pub psnr_db: f64,
    pub psnr_worst_db: f64,
    pub pixels_over_8: f64,
    pub pops: Option<f64>,
    pub flip_mean: Option<f64>,
    pub psnr_to_64_db: f64,
    pub flip_to_64: Option<f64>,
    pub on_front: bool,
}

impl Row {
    pub fn of(measurement: &Measurement, setting: &Setting) -> Vec<Self> {
        let runs = setting.runs.iter().zip(&measurement.techniques);
        let reference = quartile(&setting.runs[0]);
        let shot = &measurement.shots[setting.shot];
        let row = |(run, technique): (&Run, &Technique)| {
            let frames = run.times.len();
            let per_frame = |count: u64| count as f64 / frames as f64;
            let psnr = run.differences.iter().map(|difference| difference.psnr);
            let over_8: usize = run.differences.iter().map(|each| each.over_8).sum();
            let ms = percentile(&run.times, 50);
            Self {
                scene: shot.scene.to_string(),
                width: setting.size.width,
                height: setting.size.height,
                threads: setting.threads,
                isa: measurement.isa.name,
                name: technique.name.clone(),
                quality: technique.quality,
                sampling: technique.sampling,
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
                pops: mean(&run.view_errors.pops),
                flip_mean: mean(&run.view_errors.flips),
                psnr_to_64_db: Difference::pooled_psnr(&run.view_errors.differences_to_64),
                flip_to_64: mean(&run.view_errors.flips_to_64),
                on_front: false,
            }
        };
        runs.map(row).collect()
    }

    pub fn is_exact(&self) -> bool {
        self.psnr_db.is_infinite()
    }
}

pub fn quartile(run: &Run) -> f64 {
    percentile(&run.times, 25)
}

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

const COLUMNS: [Column<Row>; 18] = [
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
    ("dB to exhaustive", |row| decimals(row.psnr_db, 1)),
    ("worst frame", |row| decimals(row.psnr_worst_db, 1)),
    ("over 8/255", |row| format!("{:.1}", row.pixels_over_8)),
    ("pops", |row| decimals(row.pops, 1)),
    ("FLIP", |row| decimals(row.flip_mean, 4)),
    ("dB to 64 samples", |row| decimals(row.psnr_to_64_db, 1)),
    ("FLIP to 64", |row| decimals(row.flip_to_64, 4)),
];

const ERRORS: &str =
    "dB to exhaustive, worst frame, over 8/255, pops, FLIP, dB to 64 samples, FLIP to 64";

/// Adds the error columns.
pub fn table<'a>(titles: &str, rows: impl IntoIterator<Item = &'a Row> + Clone) -> String {
    let titles = titles.split(", ").chain(ERRORS.split(", "));
    let column = |title| COLUMNS.into_iter().find(|column| column.0 == title);
    let columns = titles.map(|title| column(title).expect("a column"));
    aligned(&columns.collect::<Vec<_>>(), rows)
}

struct Race {
    own: Row,
    /// Scale, and dB to 64 samples, at equal time.
    enlarged: [f64; 2],
    checkerboard: Option<Row>,
}

const RACES: [Column<Race>; 8] = [
    ("scene", |race| race.own.scene.clone()),
    ("quality", |race| race.own.name.clone()),
    ("speed-up", |race| decimals(race.own.speedup, 2)),
    ("dB to 64 samples", |race| decimals(race.own.psnr_to_64_db, 1)),
    ("resolution", |race| decimals(race.enlarged[0], 2)),
    ("its dB to 64", |race| decimals(race.enlarged[1], 1)),
    ("ahead by", |race| decimals(race.own.psnr_to_64_db - race.enlarged[1], 1)),
    ("checkerboard", |race| {
        let row = race.checkerboard.as_ref();
        let [speedup, psnr] = [row.map(|row| row.speedup), row.map(|row| row.psnr_to_64_db)];
        format!("{}, {}", decimals(speedup, 2), decimals(psnr, 1))
    }),
];

/// Compares qualities with the checkerboard and with enlarged frames of equal time, by
/// interpolation.
pub fn races(rows: &[Row]) -> String {
    let setting = |row: &Row| (row.scene.clone(), row.width, row.height, row.threads);
    let settings = rows.chunk_by(|a, b| setting(a) == setting(b));
    let races = settings.flat_map(|rows| {
        let frame = |row: &Row| {
            let scale = match row.sampling {
                Sampling::Enlarged(scale) => Some(scale),
                _ => row.is_exact().then_some(1.0),
            };
            scale.map(|scale| [row.speedup, scale, row.psnr_to_64_db])
        };
        let mut frames: Vec<[f64; 3]> = rows.iter().filter_map(frame).collect();
        frames.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let is_checkerboard = |row: &&Row| row.sampling == Sampling::Checkerboard;
        let checkerboard = rows.iter().find(is_checkerboard);
        let is_quality = |row: &&Row| row.sampling == Sampling::Full && !row.is_exact();
        rows.iter().filter(is_quality).map(move |own| Race {
            own: own.clone(),
            enlarged: at_speed(&frames, own.speedup),
            checkerboard: checkerboard.cloned(),
        })
    });
    aligned(&RACES, &races.collect::<Vec<_>>())
}

/// Interpolates points sorted by speed-up, clamped to the ends.
fn at_speed(points: &[[f64; 3]], speedup: f64) -> [f64; 2] {
    let next = points.iter().position(|point| point[0] >= speedup);
    let next = next.unwrap_or(points.len() - 1);
    let (a, b) = (points[next.saturating_sub(1)], points[next]);
    let share = ((speedup - a[0]) / (b[0] - a[0])).clamp(0.0, 1.0);
    let share = if next == 0 { 1.0 } else { share };
    [1, 2].map(|i| a[i] + share * (b[i] - a[i]))
}

fn percent(fraction: f64) -> String {
    format!("{:.1} %", 100.0 * fraction)
}

/// Formats `digits` decimals, or a dash for unknown or infinite numbers.
fn decimals(number: impl Into<Option<f64>>, digits: usize) -> String {
    match number.into().filter(|number| number.is_finite()) {
        Some(number) => format!("{number:.digits$}"),
        None => "-".to_owned(),
    }
}

type Column<R> = (&'static str, fn(&R) -> String);

/// Aligns columns in plain text, too.
fn aligned<'a, R: 'a>(
    columns: &[Column<R>],
    rows: impl IntoIterator<Item = &'a R> + Clone,
) -> String {
    let columns: Vec<Vec<String>> = columns
        .iter()
        .map(|(title, cell)| {
            let cells = rows.clone().into_iter().map(cell);
            let cells: Vec<String> = [(*title).to_owned()].into_iter().chain(cells).collect();
            let width = cells.iter().map(|cell| cell.chars().count()).max();
            let width = width.unwrap_or(0).max(2);
            let mut cells: Vec<String> =
                cells.iter().map(|cell| format!("{cell:>width$}")).collect();
            cells.insert(1, format!("{}:", "-".repeat(width - 1)));
            cells
        })
        .collect();
    let lines = columns.first().map_or(0, Vec::len);
    let line = |i: usize| {
        let cells: Vec<&str> = columns.iter().map(|cells| cells[i].as_str()).collect();
        format!("| {} |\n", cells.join(" | "))
    };
    (0..lines).map(line).collect()
}

fn mean(numbers: &[f64]) -> Option<f64> {
    (!numbers.is_empty()).then(|| numbers.iter().sum::<f64>() / numbers.len() as f64)
}

/// Returns the smallest time that `percent` % of the times do not exceed.
fn percentile(times: &[f64], percent: usize) -> f64 {
    let mut times = times.to_vec();
    times.sort_by(f64::total_cmp);
    times[(times.len() * percent).div_ceil(100) - 1]
}

pub fn machine() -> String {
    let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let models = info.lines().filter(|line| line.starts_with("model name"));
    let model = models.filter_map(|line| line.split_once(": ")).next();
    let model = model.map_or("unknown processor", |(_, model)| model);
    format!("{model}, {} processors", processors())
}
