//! Writes the measured points as comma-separated values, with the same names as in JSON.

use super::outcome::Outcome;

/// A column: its title, and the text for a row.
type Column = (&'static str, fn(&Outcome) -> String);

const COLUMNS: [Column; 29] = [
    ("name", |row| row.name.clone()),
    ("dials", |row| row.dials.clone()),
    ("sweep", |row| format!("\"{}\"", row.sweep)),
    ("square", |row| row.square.to_string()),
    ("tolerance_agreeing", |row| {
        row.tolerance_agreeing.to_string()
    }),
    ("tolerance_differing", |row| {
        row.tolerance_differing.to_string()
    }),
    ("tolerance_side", |row| row.tolerance_side.to_string()),
    ("guarded", |row| row.guarded.to_string()),
    ("key_depth", |row| row.key_depth.to_string()),
    ("state_depth", |row| row.state_depth.to_string()),
    ("highlight", |row| row.highlight.to_string()),
    ("depth", |row| row.depth.to_string()),
    ("least_contribution", |row| {
        row.least_contribution.to_string()
    }),
    ("antialias", |row| row.antialias.to_string()),
    ("keys", |row| row.keys.to_string()),
    ("frames", |row| row.frames.to_string()),
    ("speedup", |row| format!("{:.4}", row.speedup)),
    ("traced_fraction", |row| {
        format!("{:.6}", row.traced_fraction)
    }),
    ("rays", |row| format!("{:.1}", row.rays)),
    ("psnr_db", |row| finite(row.psnr_db)),
    ("psnr_worst_db", |row| finite(row.psnr_worst_db)),
    ("largest_error", |row| row.largest_error.to_string()),
    ("pixels_over_8", |row| format!("{:.2}", row.pixels_over_8)),
    ("missed_objects", |row| format!("{:.3}", row.missed_objects)),
    ("pops", |row| known(row.pops)),
    ("flip_mean", |row| known(row.flip_mean)),
    ("flip_p99", |row| known(row.flip_p99)),
    ("psnr_to_64_db", |row| {
        row.psnr_to_64_db.map_or_else(String::new, finite)
    }),
    ("flip_to_64", |row| known(row.flip_to_64)),
];

fn known(number: Option<f64>) -> String {
    number.map_or_else(String::new, |number| format!("{number:.6}"))
}

fn finite(decibels: f64) -> String {
    if decibels.is_finite() {
        format!("{decibels:.4}")
    } else {
        String::new()
    }
}

/// A line of titles and a line for each row. The last column tells whether the point is on the Pareto front.
pub fn csv(rows: &[Outcome]) -> String {
    let titles = COLUMNS.map(|(title, _)| title).join(",");
    let lines = rows.iter().map(|row| {
        let cells = COLUMNS.map(|(_, cell)| cell(row)).join(",");
        format!("{cells},{}\n", row.on_front)
    });
    format!("{titles},on_front\n{}", lines.collect::<String>())
}
