//! The results for a point.

use super::tally::Tally;
use crate::timing::percentile;
use serde::Serialize;

/// The results for one quality.
///
/// Counts are means per frame, fractions are from 0 to 1, errors are against the exhaustive frames. In JSON `null` stands for an
/// infinite dial, for the PSNR of equal frames, and for what was not measured before Ctrl-C. In CSV an infinite dial is `inf`,
/// and the others are empty.
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
    /// Flickering blocks, see [`crate::flicker`].
    pub flicker_blocks: Option<f64>,
    /// The mean of FLIP at 67 pixels per degree.
    pub flip_mean: Option<f64>,
    /// The 99th percentile of FLIP over the pixels.
    pub flip_p99: Option<f64>,
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
        // The mean is taken over the squared errors, since the PSNR of equal frames is infinite.
        let squares = differences.iter().map(|d| 10_f64.powf(-0.1 * d.psnr)).sum();
        let quality = &tally.point.quality;
        let flips = (!tally.flips.is_empty()).then_some(&tally.flips);
        let flip = |part: fn(&(f64, f64)) -> f64| {
            flips.map(|flips| flips.iter().map(part).sum::<f64>() / flips.len() as f64)
        };
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
            psnr_db: -10.0 * mean(squares).log10(),
            psnr_worst_db: worst,
            largest_error: differences.iter().map(|d| d.largest).max().unwrap_or(0),
            pixels_over_8: mean(differences.iter().map(|d| d.over_8).sum::<usize>() as f64),
            missed_objects: mean(tally.missed as f64),
            flicker_blocks: tally.flicker.per_frame(),
            flip_mean: flip(|flip| flip.0),
            flip_p99: flip(|flip| flip.1),
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

/// Marks the Pareto front: the points for which no other point is both faster and more accurate, among those that keep the rules
/// of the product.
pub fn mark_front(rows: &mut [Outcome]) {
    let mut order: Vec<usize> = (0..rows.len()).collect();
    order.sort_by(|&a, &b| rows[b].speedup.total_cmp(&rows[a].speedup));
    let mut best = f64::NEG_INFINITY;
    for i in order {
        let row = &mut rows[i];
        if row.keeps_the_rules() && row.psnr_db > best {
            best = row.psnr_db;
            row.on_front = true;
        }
    }
}
