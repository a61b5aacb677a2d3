//! What is recorded of a point while it is measured.

use super::sweep::Point;
use crate::error::Difference;
use crate::views::Seen;
use eightfold_tracer::Counts;

/// The records of a point.
pub struct Tally {
    pub point: Point,
    /// The seconds that each frame took.
    pub times: Vec<f64>,
    /// The seconds of the faster one of the exhaustive frames before and after each frame.
    pub exhaustive_times: Vec<f64>,
    /// The work for all frames together.
    pub counts: Counts,
    /// The error of each frame.
    pub differences: Vec<Difference>,
    /// The number of missed objects in all frames together.
    pub missed: usize,
    /// Of the views.
    pub seen: Seen,
}

impl Tally {
    /// Empty records.
    pub fn new(point: Point) -> Self {
        Self {
            point,
            times: Vec::new(),
            exhaustive_times: Vec::new(),
            counts: Counts::NONE,
            differences: Vec::new(),
            missed: 0,
            seen: Seen::default(),
        }
    }
}
