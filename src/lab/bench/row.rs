//! The figures of a run.

use super::measure::{Plan, Setting, Shot};
use crate::error::Difference;
use crate::interrupt;
use crate::timing::{median, percentile};
use crate::views::Seen;
use serde::Serialize;

/// The measurements of one quality in one setting.
///
/// Times are in milliseconds, counts are means of a frame, shares are of 1. An infinite PSNR, where no pixel differs, is
/// `null` in JSON, and what was not measured to its end.
#[derive(Serialize)]
pub struct Row {
    pub scene: String,
    pub width: usize,
    pub height: usize,
    pub threads: usize,
    pub isa: &'static str,
    pub quality: String,
    /// Frames drawn.
    pub frames: usize,
    pub fps_median: f64,
    /// In the second of the scene, or of the show, whose frames took longest.
    pub fps_worst_second: f64,
    /// When it begins, in seconds.
    #[serde(skip)]
    pub worst_second: f64,
    pub ms_median: f64,
    /// 99 of 100 frames took no longer.
    pub ms_p99: f64,
    /// Points traced for each pixel of the picture.
    pub traced_fraction: f64,
    /// Primary and secondary rays.
    pub rays: f64,
    pub shadow_rays: f64,
    /// Primary and secondary rays for each lane that could have carried one.
    pub lane_occupancy: f64,
    /// The PSNR of all frames together against the exhaustive ones.
    pub psnr_db: f64,
    pub psnr_worst_db: f64,
    /// Pixels with a channel more than 8 of 255 off.
    pub pixels_over_8: f64,
    /// Pixels that jump from a frame to the next while the exhaustive frames' stay, see [`crate::views`]; `null` if no view has a
    /// second frame.
    pub pops: Option<f64>,
    /// The mean of FLIP at 67 pixels per degree, and its 99th percentile, of the views against the exhaustive ones.
    pub flip_mean: Option<f64>,
    pub flip_p99: Option<f64>,
    /// The PSNR and the mean of FLIP against exhaustive frames with 64 samples a pixel.
    pub psnr_to_64_db: Option<f64>,
    pub flip_to_64: Option<f64>,
    /// The exhaustive frames' median time over this one.
    pub speedup_vs_exhaustive: f64,
    /// The median time over that of filling the frame with one colour.
    pub floor_ratio: f64,
}

impl Row {
    /// The rows of a setting, one for each run.
    pub fn of(plan: &Plan, setting: &Setting) -> Vec<Self> {
        let shot = &plan.shots[setting.shot];
        let frames = setting.floor.len();
        let floor = median(&setting.floor);
        let exhaustive = median(&setting.runs[0].times);
        let rows = setting.runs.iter().map(|run| {
            let per_frame = |count: u64| count as f64 / frames as f64;
            let ms = median(&run.times);
            let (worst_second, worst_ms) = worst_second(shot, &run.times);
            let psnr = run.differences.iter().map(|difference| difference.psnr);
            let over_8: usize = run.differences.iter().map(|d| d.over_8).sum();
            // Of views that an interrupt cut short nothing is told.
            let seen = (!interrupt::is_stopped()).then_some(&run.seen);
            Self {
                scene: shot.scene.to_string(),
                width: setting.size.width,
                height: setting.size.height,
                threads: setting.threads,
                isa: plan.isa.name,
                quality: run.way.name(),
                frames,
                fps_median: 1e3 / ms,
                fps_worst_second: 1e3 / worst_ms,
                worst_second,
                ms_median: ms,
                ms_p99: percentile(&run.times, 99),
                traced_fraction: per_frame(run.counts.points) / setting.size.area() as f64,
                rays: per_frame(run.counts.rays),
                shadow_rays: per_frame(run.counts.shadow_rays),
                lane_occupancy: run.counts.rays as f64 / run.counts.lanes as f64,
                psnr_db: Difference::pooled_psnr(&run.differences),
                psnr_worst_db: psnr.fold(f64::INFINITY, f64::min),
                pixels_over_8: per_frame(over_8 as u64),
                pops: seen.and_then(Seen::pops),
                flip_mean: seen.and_then(|seen| seen.flips.mean()),
                flip_p99: seen.and_then(|seen| seen.flips.p99()),
                psnr_to_64_db: seen.and_then(Seen::psnr_to_64_db),
                flip_to_64: seen.and_then(|seen| seen.flips_to_64.mean()),
                speedup_vs_exhaustive: exhaustive / ms,
                floor_ratio: ms / floor,
            }
        });
        rows.collect()
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
