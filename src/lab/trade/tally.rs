//! What is summed up of a point while it is measured.

use super::sweep::Point;
use crate::error::Difference;
use crate::flicker::Flicker;
use eightfold::Counts;

/// A point at work.
pub struct Tally {
    pub point: Point,
    /// Seconds of each frame, and of the faster exhaustive one of the two drawn before and after it.
    pub times: Vec<f64>,
    pub exhaustive_times: Vec<f64>,
    /// Of all frames together.
    pub counts: Counts,
    /// Of each frame to the exhaustive one.
    pub differences: Vec<Difference>,
    /// Objects missed, of all frames together.
    pub missed: usize,
    pub flicker: Flicker,
    /// FLIP's mean and 99th percentile of each frame looked at.
    pub flips: Vec<(f64, f64)>,
}

impl Tally {
    /// Nothing measured yet.
    pub fn new(point: Point) -> Self {
        Self {
            point,
            times: Vec::new(),
            exhaustive_times: Vec::new(),
            counts: Counts::NONE,
            differences: Vec::new(),
            missed: 0,
            flicker: Flicker::default(),
            flips: Vec::new(),
        }
    }
}
