//! Rows as a table in Markdown.

use super::row::Row;
use crate::accuracy::{error_columns, sample_columns, traced_column};
use crate::markdown::{Column, percent, table};

const SIZE: Column<Row> = ("size", |row| format!("{}x{}", row.width, row.height));
const THREADS: Column<Row> = ("threads", |row| row.threads.to_string());
const QUALITY: Column<Row> = ("quality", |row| row.quality.clone());
const FPS: Column<Row> = ("fps median", |row| format!("{:.1}", row.fps_median));
const MS: Column<Row> = ("ms median", |row| format!("{:.3}", row.ms_median));
const MS_P99: Column<Row> = ("ms p99", |row| format!("{:.3}", row.ms_p99));

/// A line for each row.
pub fn of_scene(rows: &[Row]) -> String {
    let mut columns: Vec<Column<Row>> = vec![
        SIZE,
        THREADS,
        ("isa", |row| row.isa.to_owned()),
        QUALITY,
        FPS,
        MS,
        MS_P99,
        traced_column(),
        ("rays", |row| format!("{:.0}", row.accuracy.rays)),
        ("shadow rays", |row| {
            format!("{:.0}", row.accuracy.shadow_rays)
        }),
        ("lanes used", |row| percent(row.accuracy.lane_occupancy)),
    ];
    columns.extend(error_columns());
    columns.extend(sample_columns());
    columns.push(("speed-up", |row| {
        format!("{:.2}", row.speedup_vs_exhaustive)
    }));
    columns.push(("floor", |row| format!("{:.1}", row.floor_ratio)));
    table(&columns, rows)
}

/// A line for each row, and the worst second of the show for each size and number of threads.
pub fn of_show(rows: &[Row]) -> String {
    let mut columns: Vec<Column<Row>> = vec![
        SIZE,
        THREADS,
        ("scene", |row| row.scene.clone()),
        QUALITY,
        FPS,
        ("worst second", |row| format!("{:.1}", row.fps_worst_second)),
        MS,
        MS_P99,
        traced_column(),
    ];
    columns.extend(error_columns());
    columns.extend(sample_columns());
    let mut text = table(&columns, rows) + "\n";
    let setting = |row: &Row| (row.threads, row.width, row.height);
    for rows in rows.chunk_by(|a, b| setting(a) == setting(b)) {
        let (threads, width, height) = setting(&rows[0]);
        let first = rows.iter().take_while(|row| row.scene == rows[0].scene);
        let worst = first.map(|row| worst_second(rows, &row.quality));
        let worst: Vec<String> = worst.collect();
        text += &format!(
            "Worst second of the show at {width}x{height}, threads {threads}: {}\n",
            worst.join(", ")
        );
    }
    text
}

/// The worst second of a quality in some scenes.
fn worst_second(rows: &[Row], quality: &str) -> String {
    let rows = rows.iter().filter(|row| row.quality == quality);
    let worst = rows.min_by(|a, b| a.fps_worst_second.total_cmp(&b.fps_worst_second));
    worst.map_or(String::new(), |row| {
        let (fps, second) = (row.fps_worst_second, row.worst_second);
        format!("{quality} {fps:.1} fps from {second} s ({})", row.scene)
    })
}
