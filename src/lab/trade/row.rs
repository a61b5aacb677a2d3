//! The figures of a point.

use super::tally::Tally;
use serde::Serialize;

/// What was measured of one quality.
///
/// Counts are means of a frame, shares are of 1, errors are against the exhaustive frames. In JSON `null` stands for an
/// infinite dial, for a PSNR where nothing differs, and for what there was no time to measure; in CSV an infinite dial is
/// `inf` and the rest is empty.
#[derive(Clone, Serialize)]
pub struct Row {
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
    pub antialias: usize,
    /// Whether it compares keys.
    pub keys: bool,
    /// Frames against the clock.
    pub frames: usize,
    /// The time that a quarter of the exhaustive frames stay within over that of this one's frames: whoever else is at
    /// work on the machine lengthens the other frames, and long ones more than short ones.
    pub speedup: f64,
    /// Points traced for each pixel of the picture.
    pub traced_fraction: f64,
    /// Primary, secondary and shadow rays.
    pub rays: f64,
    /// Of the mean squared error of all frames; the worst frame's.
    pub psnr_db: f64,
    pub psnr_worst_db: f64,
    /// The largest of any channel, pixel and frame, of 255.
    pub largest_error: u32,
    /// Pixels with a channel more than 8 of 255 off.
    pub pixels_over_8: f64,
    /// Objects of whose pixels more than three in four are that far off.
    pub missed_objects: f64,
    /// Blocks of 8x8 pixels whose error moves by more than 8 of 255 from a frame to the next.
    pub flicker_blocks: Option<f64>,
    /// FLIP at 67 pixels per degree, its mean and the 99th percentile of the pixels.
    pub flip_mean: Option<f64>,
    pub flip_p99: Option<f64>,
    /// No other point without fault is both faster and nearer to the exhaustive frames.
    pub on_front: bool,
}

impl Row {
    /// The figures of a point that at least one frame was drawn of.
    pub fn of(tally: &Tally, area: usize) -> Self {
        let frames = tally.differences.len();
        let mean = |sum: f64| sum / frames as f64;
        let differences = &tally.differences;
        let worst = differences
            .iter()
            .map(|d| d.psnr)
            .fold(f64::INFINITY, f64::min);
        // A PSNR is a logarithm, which has no mean where nothing differs; the squared errors have.
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
            speedup: quartile(&tally.exhaustive_times) / quartile(&tally.times),
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

    /// Whether nothing at all differs from the exhaustive frames.
    pub fn is_exact(&self) -> bool {
        self.psnr_db.is_infinite()
    }
}

/// What a quarter of some times stay within.
pub fn quartile(times: &[f64]) -> f64 {
    let mut times = times.to_vec();
    times.sort_by(f64::total_cmp);
    times[times.len().div_ceil(4) - 1]
}

/// Marks the Pareto front: the points than which no other is faster and nearer to the exhaustive frames at once. Points
/// that miss objects are none to recommend, in this scene or for want of a guard in others, and stay behind it.
pub fn mark_front(rows: &mut [Row]) {
    let mut order: Vec<usize> = (0..rows.len()).collect();
    order.sort_by(|&a, &b| rows[b].speedup.total_cmp(&rows[a].speedup));
    let mut best = f64::NEG_INFINITY;
    for i in order {
        let row = &mut rows[i];
        if row.guarded && row.missed_objects == 0.0 && row.psnr_db > best {
            best = row.psnr_db;
            row.on_front = true;
        }
    }
}
