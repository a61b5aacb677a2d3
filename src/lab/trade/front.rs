use crate::row::Row;
use crate::technique::Sampling;

/// Marks the Pareto front of allowed rows in speed, FLIP and pops. After Ctrl-C, PSNR replaces FLIP and pops.
pub fn mark(rows: &mut [Row]) {
    let costs = |row: &Row| match (row.flip_mean, row.pops) {
        (Some(flip), Some(pops)) => [-row.speedup, flip, pops],
        _ => [-row.speedup, -row.psnr_db, 0.0],
    };
    let all = rows.iter().filter(|row| is_allowed(row)).map(costs);
    let all: Vec<[f64; 3]> = all.collect();
    for row in rows {
        let own = costs(row);
        let beats = |other: &[f64; 3]| *other != own && (0..3).all(|i| other[i] <= own[i]);
        row.on_front = is_allowed(row) && !all.iter().any(beats);
    }
}

pub fn from_the_slowest(rows: &[Row]) -> Vec<&Row> {
    let on_front = |row: &&Row| row.on_front && !row.is_exact();
    let mut front: Vec<&Row> = rows.iter().filter(on_front).collect();
    front.sort_by(|a, b| a.speedup.total_cmp(&b.speedup));
    front
}

/// Requires a guard, and comparisons of colours, objects and lights.
fn is_allowed(row: &Row) -> bool {
    let quality = &row.quality;
    let compares_keys = quality.tolerance_differing == 0.0 && quality.tolerance_agreeing != 0.0;
    let has_rules = quality.guarded && (compares_keys || quality.square == 1);
    row.sampling == Sampling::Full && has_rules
}
