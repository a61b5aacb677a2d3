//! Rows as a table in Markdown.

use super::row::Row;

/// A column's title, and what a row says in it.
type Column = (&'static str, fn(&Row) -> String);

const COLUMNS: [Column; 17] = [
    ("size", |row| format!("{}x{}", row.width, row.height)),
    ("threads", |row| row.threads.to_string()),
    ("isa", |row| row.isa.to_owned()),
    ("quality", |row| row.quality.to_owned()),
    ("fps median", |row| format!("{:.1}", row.fps_median)),
    ("ms median", |row| format!("{:.3}", row.ms_median)),
    ("ms p99", |row| format!("{:.3}", row.ms_p99)),
    ("traced", |row| percent(row.traced_fraction)),
    ("rays", |row| format!("{:.0}", row.rays)),
    ("shadow rays", |row| format!("{:.0}", row.shadow_rays)),
    ("lanes used", |row| percent(row.lane_occupancy)),
    ("PSNR mean", |row| decibels(row.psnr_mean_db)),
    ("PSNR worst", |row| decibels(row.psnr_worst_db)),
    ("over 8/255", |row| format!("{:.1}", row.pixels_over_8)),
    ("flicker", |row| row.flicker.to_string()),
    ("speed-up", |row| {
        format!("{:.2}", row.speedup_vs_exhaustive)
    }),
    ("floor", |row| format!("{:.1}", row.floor_ratio)),
];

fn percent(share: f64) -> String {
    format!("{:.1} %", 100.0 * share)
}

/// A PSNR, or nothing where nothing differs.
fn decibels(psnr: f64) -> String {
    if psnr.is_finite() {
        format!("{psnr:.1} dB")
    } else {
        "-".to_owned()
    }
}

/// A line for each row, in columns that line up as plain text too.
pub fn markdown(rows: &[Row]) -> String {
    let columns = COLUMNS.map(|(title, cell)| {
        let cells: Vec<String> = rows.iter().map(cell).collect();
        let longest = cells.iter().map(String::len).max().unwrap_or(0);
        let width = longest.max(title.len());
        (title, cells, width)
    });
    let titles = columns
        .each_ref()
        .map(|(title, _, width)| format!("{title:>width$}"));
    let rules = columns
        .each_ref()
        .map(|(_, _, width)| format!("{}:", "-".repeat(width - 1)));
    let mut text = line(&titles) + &line(&rules);
    for i in 0..rows.len() {
        let cells = columns
            .each_ref()
            .map(|(_, cells, width)| format!("{:>width$}", cells[i]));
        text += &line(&cells);
    }
    text
}

fn line(cells: &[String]) -> String {
    format!("| {} |\n", cells.join(" | "))
}
