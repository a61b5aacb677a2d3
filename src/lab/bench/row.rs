//! The figures of a run.

use crate::accuracy::Accuracy;
use crate::measure::{Plan, Setting, Shot};
use crate::timing::{median, percentile};
use serde::Serialize;

/// The measurements of one quality in one setting.
///
/// Times are in milliseconds.
#[derive(Serialize)]
pub struct Row {
    pub scene: String,
    pub width: usize,
    pub height: usize,
    pub threads: usize,
    pub isa: &'static str,
    pub quality: String,
    pub fps_median: f64,
    /// In the second of the scene, or of the show, whose frames took longest.
    pub fps_worst_second: f64,
    /// When it begins, in seconds.
    #[serde(skip)]
    pub worst_second: f64,
    pub ms_median: f64,
    /// 99 of 100 frames took no longer.
    pub ms_p99: f64,
    #[serde(flatten)]
    pub accuracy: Accuracy,
    /// The exhaustive frames' median time over this one.
    pub speedup_vs_exhaustive: f64,
    /// The median time over that of filling the frame with one colour.
    pub floor_ratio: f64,
}

impl Row {
    /// The rows of a setting, one for each run.
    pub fn of(plan: &Plan, setting: &Setting) -> Vec<Self> {
        let shot = &plan.shots[setting.shot];
        let floor = median(&setting.floor);
        let exhaustive = median(&setting.runs[0].times);
        let runs = setting.runs.iter().zip(&plan.ways);
        let rows = runs.map(|(run, way)| {
            let ms = median(&run.times);
            let (worst_second, worst_ms) = worst_second(shot, &run.times);
            Self {
                scene: shot.scene.to_string(),
                width: setting.size.width,
                height: setting.size.height,
                threads: setting.threads,
                isa: plan.isa.name,
                quality: way.name.clone(),
                fps_median: 1e3 / ms,
                fps_worst_second: 1e3 / worst_ms,
                worst_second,
                ms_median: ms,
                ms_p99: percentile(&run.times, 99),
                accuracy: Accuracy::of(setting.size.area(), run),
                speedup_vs_exhaustive: exhaustive / ms,
                floor_ratio: ms / floor,
            }
        });
        rows.collect()
    }
}

impl AsRef<Accuracy> for Row {
    fn as_ref(&self) -> &Accuracy {
        &self.accuracy
    }
}

/// The second of the show, or of a scene that stands alone, whose frames took longest: when it begins, and the mean of
/// their milliseconds.
fn worst_second(shot: &Shot, times: &[f64]) -> (f64, f64) {
    let start = shot.scene.start().unwrap_or(0.0);
    let seconds = shot
        .times
        .iter()
        .map(|time| f64::from(start + time).floor());
    let frames: Vec<(f64, f64)> = seconds.zip(times.iter().copied()).collect();
    let means = frames.chunk_by(|a, b| a.0 == b.0).map(|second| {
        let sum: f64 = second.iter().map(|(_, ms)| ms).sum();
        (second[0].0, sum / second.len() as f64)
    });
    means
        .max_by(|a, b| a.1.total_cmp(&b.1))
        .expect("there is a frame")
}
