//! Tables of the results in Markdown.

use super::Trade;
use super::outcome::{Outcome, from_the_slowest};
use crate::accuracy::{error_columns, sample_columns, traced_column};
use crate::arguments::edges;
use crate::markdown::{Column, table};

/// The table of the Pareto front, from the slowest point to the fastest, without those that have no error.
pub fn front_table(trade: &Trade) -> String {
    let on_front = trade.points.iter();
    let on_front = on_front.filter(|row| row.on_front && !row.is_exact());
    heading(trade) + &table(&columns(), from_the_slowest(on_front))
}

/// The table of the named qualities, in their order, with their dials and their distance to 64 samples a pixel.
pub fn ladder(trade: &Trade) -> String {
    let mut columns = columns();
    columns.insert(1, ("dials", |row| row.dials.clone()));
    columns.extend(sample_columns());
    heading(trade) + &table(&columns, &trade.points)
}

fn heading(trade: &Trade) -> String {
    let early = if trade.complete {
        ""
    } else {
        "; stopped early"
    };
    let edges = edges(trade.antialias);
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

/// The columns of both tables.
fn columns() -> Vec<Column<Outcome>> {
    let mut columns: Vec<Column<Outcome>> = vec![
        ("quality", |row| row.name.clone()),
        ("speed-up", |row| format!("{:.2}", row.speedup)),
        traced_column(),
    ];
    columns.extend(error_columns());
    columns.push(("missed", |row| format!("{:.2}", row.missed_objects)));
    columns
}
