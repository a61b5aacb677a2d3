//! The results for a point.

use super::sweep::{dials, has_keys};
use crate::accuracy::Accuracy;
use crate::measure::Run;
use crate::way::Way;
use eightfold_tracer::Quality;
use serde::Serialize;

/// The results for one quality. In JSON `null` stands for an infinite dial, too.
#[derive(Clone, Serialize)]
pub struct Outcome {
    pub name: String,
    pub dials: String,
    #[serde(flatten)]
    pub quality: Quality,
    /// Whether keys are compared.
    pub keys: bool,
    /// The first quartile of the exhaustive frames' times over that of this quality's.
    pub speedup: f64,
    #[serde(flatten)]
    pub accuracy: Accuracy,
    /// Missed objects of a frame, see [`crate::missed`].
    pub missed_objects: f64,
    /// Whether it is on the Pareto front, see [`mark_front`].
    pub on_front: bool,
}

impl AsRef<Accuracy> for Outcome {
    fn as_ref(&self) -> &Accuracy {
        &self.accuracy
    }
}

impl Outcome {
    /// The results for a way with at least one frame of `area` pixels, beside exhaustive frames.
    pub fn of(way: &Way, area: usize, run: &Run, exhaustive: &Run) -> Self {
        Self {
            keys: has_keys(&way.quality),
            name: way.name.clone(),
            dials: dials(&way.quality),
            quality: way.quality,
            speedup: exhaustive.quartile() / run.quartile(),
            accuracy: Accuracy::of(area, run),
            missed_objects: run.missed as f64 / run.differences.len() as f64,
            on_front: false,
        }
    }

    /// Whether all frames equal the exhaustive ones.
    pub fn is_exact(&self) -> bool {
        self.accuracy.psnr_db.is_infinite()
    }

    /// Whether it has a name of its own.
    pub fn is_named(&self) -> bool {
        self.name != self.dials
    }

    /// Whether it keeps the rules of the product: a square is filled only where the corners' colours, the objects that they show
    /// and the states of the lights agree, and no object is missed.
    fn keeps_the_rules(&self) -> bool {
        let compares_keys = self.keys && self.quality.tolerance_differing == 0.0;
        let is_guarded = self.quality.guarded && self.missed_objects == 0.0;
        (compares_keys || self.quality.square == 1) && is_guarded
    }
}

/// Marks the Pareto front of time against what is seen: the points that keep the rules of the product, and that no other of these
/// beats in speed, FLIP and pops at once. Where these were not measured, before Ctrl-C, it is the front of time against PSNR.
pub fn mark_front(rows: &mut [Outcome]) {
    let has_seen = |row: &Outcome| row.accuracy.flip_mean.zip(row.accuracy.pops).is_some();
    let is_seen = rows.iter().all(has_seen);
    let costs = |row: &Outcome| match (row.accuracy.flip_mean, row.accuracy.pops) {
        (Some(flip), Some(pops)) if is_seen => [-row.speedup, flip, pops],
        _ => [-row.speedup, -row.accuracy.psnr_db, 0.0],
    };
    let on_front = unbeaten(rows, costs);
    for (row, on_front) in rows.iter_mut().zip(on_front) {
        row.on_front = on_front;
    }
}

/// The points on the front of time against PSNR, from the slowest to the fastest, without those that have no error.
pub fn front_by_psnr(rows: &[Outcome]) -> Vec<&Outcome> {
    let on_front = unbeaten(rows, |row| [-row.speedup, -row.accuracy.psnr_db]);
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
