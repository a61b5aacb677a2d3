//! Rows as a table in Markdown.

use super::row::Row;
use crate::markdown::{dash, decibels, known, percent};

/// A column's title, and what a row says in it.
type Column = (&'static str, fn(&Row) -> String);

const SCENE: Column = ("scene", |row| row.scene.clone());
const SIZE: Column = ("size", |row| format!("{}x{}", row.width, row.height));
const THREADS: Column = ("threads", |row| row.threads.to_string());
const ISA: Column = ("isa", |row| row.isa.to_owned());
const QUALITY: Column = ("quality", |row| row.quality.clone());
const FPS: Column = ("fps median", |row| format!("{:.1}", row.fps_median));
const WORST_SECOND: Column = ("worst second", |row| format!("{:.1}", row.fps_worst_second));
const MS: Column = ("ms median", |row| format!("{:.3}", row.ms_median));
const MS_P99: Column = ("ms p99", |row| format!("{:.3}", row.ms_p99));
const TRACED: Column = ("traced", |row| percent(row.traced_fraction));
const RAYS: Column = ("rays", |row| format!("{:.0}", row.rays));
const SHADOW_RAYS: Column = ("shadow rays", |row| format!("{:.0}", row.shadow_rays));
const LANES: Column = ("lanes used", |row| percent(row.lane_occupancy));
const PSNR: Column = ("PSNR", |row| decibels(row.psnr_db));
const PSNR_WORST: Column = ("PSNR worst", |row| decibels(row.psnr_worst_db));
const OVER_8: Column = ("over 8/255", |row| format!("{:.1}", row.pixels_over_8));
const POPS: Column = ("pops", |row| known(row.pops, 1));
const FLIP: Column = ("FLIP", |row| known(row.flip_mean, 4));
const PSNR_TO_64: Column = ("PSNR to 64", |row| {
    row.psnr_to_64_db.map_or_else(dash, decibels)
});
const FLIP_TO_64: Column = ("FLIP to 64", |row| known(row.flip_to_64, 4));
const SPEED_UP: Column = ("speed-up", |row| {
    format!("{:.2}", row.speedup_vs_exhaustive)
});
const FLOOR: Column = ("floor", |row| format!("{:.1}", row.floor_ratio));

/// Of a scene.
const COLUMNS: [Column; 20] = [
    SIZE,
    THREADS,
    ISA,
    QUALITY,
    FPS,
    MS,
    MS_P99,
    TRACED,
    RAYS,
    SHADOW_RAYS,
    LANES,
    PSNR,
    PSNR_WORST,
    OVER_8,
    POPS,
    FLIP,
    PSNR_TO_64,
    FLIP_TO_64,
    SPEED_UP,
    FLOOR,
];

/// Of the show's scenes.
const SHOW_COLUMNS: [Column; 16] = [
    SIZE,
    THREADS,
    SCENE,
    QUALITY,
    FPS,
    WORST_SECOND,
    MS,
    MS_P99,
    TRACED,
    PSNR,
    PSNR_WORST,
    OVER_8,
    POPS,
    FLIP,
    PSNR_TO_64,
    FLIP_TO_64,
];

/// A line for each row.
pub fn of_scene(rows: &[Row]) -> String {
    markdown(&COLUMNS, rows)
}

/// A line for each row, and the worst second of the show for each size and number of threads.
pub fn of_show(rows: &[Row]) -> String {
    let mut text = markdown(&SHOW_COLUMNS, rows) + "\n";
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

/// A line for each row, in columns that line up as plain text too.
fn markdown(columns: &[Column], rows: &[Row]) -> String {
    let columns = columns.iter().map(|&(title, cell)| {
        let cells: Vec<String> = rows.iter().map(cell).collect();
        let longest = cells.iter().map(String::len).max().unwrap_or(0);
        let width = longest.max(title.len());
        (title, cells, width)
    });
    let columns: Vec<_> = columns.collect();
    let titles = columns.iter();
    let titles = titles.map(|(title, _, width)| format!("{title:>width$}"));
    let rules = columns.iter();
    let rules = rules.map(|(_, _, width)| format!("{}:", "-".repeat(width - 1)));
    let mut text = line(titles) + &line(rules);
    for i in 0..rows.len() {
        let cells = columns.iter();
        text += &line(cells.map(|(_, cells, width)| format!("{:>width$}", cells[i])));
    }
    text
}

fn line(cells: impl Iterator<Item = String>) -> String {
    format!("| {} |\n", cells.collect::<Vec<_>>().join(" | "))
}
