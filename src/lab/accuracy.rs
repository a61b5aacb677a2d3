//! The figures of a quality that are no times: its work, and how far its frames are off. Several commands measure them.

use crate::error::Difference;
use crate::markdown::{Column, dash, decibels, known, percent};
use crate::measure::Run;
use serde::Serialize;

/// Work and errors of the frames of a quality.
///
/// Counts are means of a frame, and shares are of 1. An infinite PSNR, where no pixel differs, is `null` in JSON, and what was not
/// measured to its end.
#[derive(Clone, Serialize)]
pub struct Accuracy {
    /// Frames drawn.
    pub frames: usize,
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
    /// The mean of FLIP at 67 pixels per degree, of the views against the exhaustive ones.
    pub flip_mean: Option<f64>,
    /// The PSNR and the mean of FLIP against exhaustive frames with 64 samples a pixel.
    pub psnr_to_64_db: Option<f64>,
    pub flip_to_64: Option<f64>,
}

impl Accuracy {
    /// That of frames of `area` pixels.
    pub fn of(area: usize, run: &Run) -> Self {
        let Run {
            counts,
            differences,
            seen,
            ..
        } = run;
        let frames = differences.len();
        let per_frame = |count: u64| count as f64 / frames as f64;
        let psnr = differences.iter().map(|difference| difference.psnr);
        let over_8: usize = differences.iter().map(|each| each.over_8).sum();
        Self {
            frames,
            traced_fraction: per_frame(counts.points) / area as f64,
            rays: per_frame(counts.rays),
            shadow_rays: per_frame(counts.shadow_rays),
            lane_occupancy: counts.rays as f64 / counts.lanes as f64,
            psnr_db: Difference::pooled_psnr(differences),
            psnr_worst_db: psnr.fold(f64::INFINITY, f64::min),
            pixels_over_8: per_frame(over_8 as u64),
            pops: seen.pops(),
            flip_mean: seen.flips.mean(),
            psnr_to_64_db: seen.psnr_to_64_db(),
            flip_to_64: seen.flips_to_64.mean(),
        }
    }
}

/// The columns that all tables of qualities have: errors against exhaustive frames, and what a viewer sees of them.
pub fn error_columns<R: AsRef<Accuracy>>() -> [Column<R>; 5] {
    [
        ("PSNR", |row| decibels(row.as_ref().psnr_db)),
        ("PSNR worst", |row| decibels(row.as_ref().psnr_worst_db)),
        ("over 8/255", |row| {
            format!("{:.1}", row.as_ref().pixels_over_8)
        }),
        ("pops", |row| known(row.as_ref().pops, 1)),
        ("FLIP", |row| known(row.as_ref().flip_mean, 4)),
    ]
}

/// The columns of the distance to 64 samples a pixel.
pub fn sample_columns<R: AsRef<Accuracy>>() -> [Column<R>; 2] {
    [
        ("PSNR to 64", |row| {
            let psnr = row.as_ref().psnr_to_64_db;
            psnr.map_or_else(dash, decibels)
        }),
        ("FLIP to 64", |row| known(row.as_ref().flip_to_64, 4)),
    ]
}

/// The column of points traced.
pub fn traced_column<R: AsRef<Accuracy>>() -> Column<R> {
    ("traced", |row| percent(row.as_ref().traced_fraction))
}
