//! The results for a point.

use super::measure::Tally;
use crate::error::Difference;
use crate::timing::percentile;
use serde::Serialize;

/// The results for one quality.
///
/// Counts are means per frame, fractions are from 0 to 1, errors are against the exhaustive frames. In JSON `null` stands for an
/// infinite dial, for the PSNR of equal frames, and for what was not measured before Ctrl-C.
#[derive(Clone, Serialize)]
pub struct Outcome {
    pub name: String,
    pub dials: String,
    pub sweep: &'static str,
    pub square: usize,
    pub tolerance_agreeing: f32,
    pub tolerance_differing: f32,
    pub tolerance_side: f32,
    pub guarded: bool,
    pub key_depth: u32,
    pub state_depth: u32,
    pub highlight: f32,
    pub depth: u32,
    pub least_contribution: f32,
    pub antialias: bool,
    /// Whether keys are compared.
    pub keys: bool,
    /// The number of timed frames.
    pub frames: usize,
    /// The first quartile of the exhaustive frames' times over that of this quality's. Other programs lengthen the times of the
    /// slower frames, so the first quartile is more stable than the median.
    pub speedup: f64,
    /// The number of traced points per pixel.
    pub traced_fraction: f64,
    /// Primary, secondary and shadow rays.
    pub rays: f64,
    /// The PSNR of all frames together.
    pub psnr_db: f64,
    /// The PSNR of the worst frame.
    pub psnr_worst_db: f64,
    /// The largest error in any channel of any pixel and frame, in steps of 1/255.
    pub largest_error: u32,
    /// Pixels with an error of more than 8/255 in a channel.
    pub pixels_over_8: f64,
    /// Missed objects, see [`crate::missed`].
    pub missed_objects: f64,
    /// Pixels that jump from a frame to the next while the exhaustive frames' stay, see [`crate::views`].
    pub pops: Option<f64>,
    /// The mean of FLIP at 67 pixels per degree.
    pub flip_mean: Option<f64>,
    /// The 99th percentile of FLIP over the pixels.
    pub flip_p99: Option<f64>,
    /// The PSNR against exhaustive frames with 64 samples a pixel, for the named qualities alone.
    pub psnr_to_64_db: Option<f64>,
    /// The mean of FLIP against the same.
    pub flip_to_64: Option<f64>,
    /// Whether it is on the Pareto front, see [`mark_front`].
    pub on_front: bool,
}

impl Outcome {
    /// The results for a point with at least one timed frame.
    pub fn of(tally: &Tally, area: usize) -> Self {
        let frames = tally.differences.len();
        let mean = |sum: f64| sum / frames as f64;
        let differences = &tally.differences;
        let worst = differences
            .iter()
            .map(|d| d.psnr)
            .fold(f64::INFINITY, f64::min);
        let quality = &tally.point.quality;
        let seen = &tally.seen;
        Self {
            name: tally.point.name.clone(),
            dials: tally.point.dials.clone(),
            sweep: tally.point.sweep,
            square: quality.square,
            tolerance_agreeing: quality.tolerance_agreeing,
            tolerance_differing: quality.tolerance_differing,
            tolerance_side: quality.tolerance_side,
            guarded: quality.guarded,
            key_depth: quality.key_depth,
            state_depth: quality.state_depth,
            highlight: quality.highlight,
            depth: quality.depth,
            least_contribution: quality.least_contribution,
            antialias: quality.antialias,
            keys: tally.point.has_keys(),
            frames,
            speedup: percentile(&tally.exhaustive_times, 25) / percentile(&tally.times, 25),
            traced_fraction: mean(tally.counts.points as f64) / area as f64,
            rays: mean((tally.counts.rays + tally.counts.shadow_rays) as f64),
            psnr_db: Difference::pooled_psnr(differences),
            psnr_worst_db: worst,
            largest_error: differences.iter().map(|d| d.largest).max().unwrap_or(0),
            pixels_over_8: mean(differences.iter().map(|d| d.over_8).sum::<usize>() as f64),
            missed_objects: mean(tally.missed as f64),
            pops: seen.pops(),
            flip_mean: seen.flips.mean(),
            flip_p99: seen.flips.p99(),
            psnr_to_64_db: seen.psnr_to_64_db(),
            flip_to_64: seen.flips_to_64.mean(),
            on_front: false,
        }
    }

    /// Whether all frames equal the exhaustive ones.
    pub fn is_exact(&self) -> bool {
        self.psnr_db.is_infinite()
    }

    /// Whether it keeps the rules of the product: a square is filled only where the corners' colours, the objects that they show
    /// and the states of the lights agree, and no object is missed.
    fn keeps_the_rules(&self) -> bool {
        let compares_keys = self.keys && self.tolerance_differing == 0.0;
        (compares_keys || self.square == 1) && self.guarded && self.missed_objects == 0.0
    }
}

/// Marks the Pareto front of time against what is seen: the points that keep the rules of the product, and that no other of these
/// beats in speed, FLIP and pops at once. Where these were not measured, before Ctrl-C, it is the front of time against PSNR.
pub fn mark_front(rows: &mut [Outcome]) {
    let is_seen = rows
        .iter()
        .all(|row| row.flip_mean.is_some() && row.pops.is_some());
    let costs = |row: &Outcome| match (row.flip_mean, row.pops) {
        (Some(flip), Some(pops)) if is_seen => [-row.speedup, flip, pops],
        _ => [-row.speedup, -row.psnr_db, 0.0],
    };
    let on_front = unbeaten(rows, costs);
    for (row, on_front) in rows.iter_mut().zip(on_front) {
        row.on_front = on_front;
    }
}

/// The points on the front of time against one error, from the slowest to the fastest, without those that have no error.
pub fn front_by(rows: &[Outcome], error: impl Fn(&Outcome) -> f64) -> Vec<&Outcome> {
    let on_front = unbeaten(rows, |row| [-row.speedup, error(row)]);
    let front = rows.iter().zip(on_front);
    let front = front.filter(|(row, on_front)| *on_front && !row.is_exact());
    from_the_slowest(front.map(|(row, _)| row))
}

/// Points in the order of their speed.
pub fn from_the_slowest<'a>(rows: impl Iterator<Item = &'a Outcome>) -> Vec<&'a Outcome> {
    let mut rows: Vec<&Outcome> = rows.collect();
    rows.sort_by(|a, b| a.speedup.total_cmp(&b.speedup));
    rows
}

/// Whether each point keeps the rules of the product, and no other one that does costs less of something and more of nothing.
fn unbeaten<const N: usize>(rows: &[Outcome], costs: impl Fn(&Outcome) -> [f64; N]) -> Vec<bool> {
    let all = rows.iter().filter(|row| row.keeps_the_rules()).map(&costs);
    let all: Vec<[f64; N]> = all.collect();
    let is_beaten = |row: &Outcome| {
        let own = costs(row);
        let beats = |other: &[f64; N]| {
            *other != own && other.iter().zip(own).all(|(other, own)| *other <= own)
        };
        all.iter().any(beats)
    };
    let rows = rows.iter();
    rows.map(|row| row.keeps_the_rules() && !is_beaten(row))
        .collect()
}
