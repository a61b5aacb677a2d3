//! The Pareto front of speed against the errors that are seen.

use crate::rivals::Way;
use crate::row::Row;
use eightfold_tracer::Quality;

/// Marks the rows that keep the rules of the product and are not beaten by another of them in speed, FLIP and pops at once. After
/// Ctrl-C, FLIP and pops are unknown: PSNR replaces them.
pub fn mark(rows: &mut [Row]) {
    let costs = |row: &Row| match (row.flip_mean, row.pops) {
        (Some(flip), Some(pops)) => [-row.speedup, flip, pops],
        _ => [-row.speedup, -row.psnr_db, 0.0],
    };
    let all = rows.iter().filter(|row| keeps_the_rules(row)).map(costs);
    let all: Vec<[f64; 3]> = all.collect();
    for row in rows {
        let own = costs(row);
        let beats = |other: &[f64; 3]| *other != own && (0..3).all(|i| other[i] <= own[i]);
        row.on_front = keeps_the_rules(row) && !all.iter().any(beats);
    }
}

/// Returns the rows on the front in the order of their speed, without those that have no error.
pub fn from_the_slowest(rows: &[Row]) -> Vec<&Row> {
    let on_front = |row: &&Row| row.on_front && !row.is_exact();
    let mut front: Vec<&Row> = rows.iter().filter(on_front).collect();
    front.sort_by(|a, b| a.speedup.total_cmp(&b.speedup));
    front
}

/// Whether a square is filled only where the corners' colours, the objects that they show and the states of the lights agree, and no
/// object is missed.
fn keeps_the_rules(row: &Row) -> bool {
    let Quality {
        square,
        guarded,
        tolerance_agreeing,
        tolerance_differing,
        ..
    } = row.quality;
    let compares_keys = tolerance_differing == 0.0 && tolerance_agreeing != 0.0;
    let misses_none = row.missed_objects.is_none_or(|missed| missed == 0.0);
    row.way == Way::Drawn && (compares_keys || square == 1) && guarded && misses_none
}
