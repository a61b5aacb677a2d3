//! Tables of the results in Markdown.

use super::Trade;
use super::outcome::{Outcome, from_the_slowest};
use crate::markdown::{dash, decibels, known, percent};

/// The table of the Pareto front, from the slowest point to the fastest, without those that have no error.
pub fn front_table(trade: &Trade) -> String {
    let on_front = trade.points.iter();
    let on_front = on_front.filter(|row| row.on_front && !row.is_exact());
    let rows = from_the_slowest(on_front);
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
    let edges = trade.edges();
    format!(
        "{}; {} scene, {}x{}, {edges} edges, {} frames from {} s to {} s{early}\n\n",
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
    let mut text = "| quality | dials | speed-up | traced | PSNR | worst | largest | over 8/255 | missed | pops | FLIP | p99 | PSNR to 64 | FLIP to 64 |\n\
                    | --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n"
        .to_owned();
    for row in rows {
        text += &format!("| {} |\n", cells(row).join(" | "));
    }
    text
}

/// The cells of a row. A dash stands for an infinite PSNR and for what was not measured.
fn cells(row: &Outcome) -> [String; 14] {
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
        known(row.pops, 1),
        known(row.flip_mean, 4),
        known(row.flip_p99, 3),
        row.psnr_to_64_db.map_or_else(dash, decibels),
        known(row.flip_to_64, 4),
    ]
}
