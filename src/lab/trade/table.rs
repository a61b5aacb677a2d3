//! Tables of the results in Markdown.

use super::Trade;
use super::outcome::Outcome;
use super::plots::front;
use crate::markdown::{decibels, percent};

/// The table of the Pareto front, from the slowest point to the fastest.
pub fn front_table(trade: &Trade) -> String {
    let rows = front(&trade.points);
    heading(trade) + &table(&rows)
}

/// The table of the named qualities, in their order.
pub fn ladder(trade: &Trade) -> String {
    let rows: Vec<&Outcome> = trade.points.iter().collect();
    heading(trade) + &table(&rows)
}

fn heading(trade: &Trade) -> String {
    let early = if trade.complete {
        ""
    } else {
        "; stopped early"
    };
    format!(
        "{}; {} scene, {}x{}, {} frames from {} s to {} s{early}\n\n",
        trade.machine,
        trade.scene,
        trade.width,
        trade.height,
        trade.times.len(),
        trade.times.first().unwrap_or(&0.0),
        trade.times.last().unwrap_or(&0.0),
    )
}

fn table(rows: &[&Outcome]) -> String {
    let mut text = "| quality | dials | speed-up | traced | PSNR | worst | largest | over 8/255 | missed | flicker | FLIP | p99 |\n\
                    | --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n"
        .to_owned();
    for row in rows {
        text += &format!("| {} |\n", cells(row).join(" | "));
    }
    text
}

/// The cells of a row. A dash stands for an infinite PSNR and for what was not measured.
fn cells(row: &Outcome) -> [String; 12] {
    let dash = || "-".to_owned();
    let known = |value: Option<f64>, digits| value.map_or_else(dash, |v| format!("{v:.digits$}"));
    [
        row.name.clone(),
        row.dials.clone(),
        format!("{:.2}", row.speedup),
        percent(row.traced_fraction),
        decibels(row.psnr_db),
        decibels(row.psnr_worst_db),
        row.largest_error.to_string(),
        format!("{:.0}", row.pixels_over_8),
        format!("{:.2}", row.missed_objects),
        known(row.flicker_blocks, 1),
        known(row.flip_mean, 4),
        known(row.flip_p99, 3),
    ]
}
