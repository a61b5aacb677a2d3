//! The plots of the results.

use super::Trade;
use super::curves::Curve;
use super::front::from_the_slowest;
use crate::arguments::NamedQuality;
use crate::output;
use crate::plot::{Chart, Series};
use crate::rivals::Way;
use crate::row::Row;
use anyhow::Result;
use eightfold_tracer::Quality;
use plotters::chart::SeriesLabelPosition::{self, *};
use std::path::Path;

const PSNR: &str = "PSNR against every pixel traced, dB";
const SPEED_UP: &str = "speed-up over exhaustive frames";

/// Writes all plots for which there are results.
pub fn write(folder: &Path, trade: &Trade) -> Result<()> {
    for (name, chart) in [
        ("front", front(trade)),
        ("squares", squares(trade)),
        (
            "resolution",
            curves(&trade.by_resolution, "pixels of the picture", UpperLeft),
        ),
        (
            "objects",
            curves(&trade.by_spheres, "small spheres", UpperRight),
        ),
    ] {
        if !chart.series.is_empty() {
            let svg = chart.svg(&trade.heading)?;
            output::write(&folder.join(format!("{name}.svg")), svg.as_bytes())?;
        }
    }
    Ok(())
}

/// The plot of all settings, the Pareto front, and the named qualities.
fn front(trade: &Trade) -> Chart {
    let is_named = |row: &&Row| NamedQuality::all().any(|named| named.name == row.name);
    let dots = |name: &str, rows: Vec<&Row>, has_labels: bool| Series {
        name: name.to_owned(),
        points: rows.iter().map(|row| (row.speedup, row.psnr_db)).collect(),
        labels: rows
            .iter()
            .filter(|_| has_labels)
            .map(|row| row.name.clone())
            .collect(),
        has_line: false,
    };
    let inexact = || trade.rows.iter().filter(|row| !row.is_exact());
    let is_rival = |row: &&Row| row.way != Way::Drawn;
    Chart {
        x: SPEED_UP,
        y: PSNR,
        legend: LowerLeft,
        series: vec![
            dots(
                "settings",
                inexact().filter(|row| !is_rival(row)).collect(),
                false,
            ),
            dots("Pareto front", from_the_slowest(&trade.rows), false),
            dots("named", inexact().filter(is_named).collect(), true),
            dots("fewer pixels", inexact().filter(is_rival).collect(), true),
        ],
    }
}

/// The plot of the error by the side of the squares, for the rules of 2008 and the default quality, with speed-ups.
fn squares(trade: &Trade) -> Chart {
    let series = |(name, base): (&str, Quality)| {
        let is_turned = |row: &&Row| {
            let Quality {
                square, antialias, ..
            } = row.quality;
            let turned = Quality {
                square,
                antialias,
                ..base
            };
            square > 1 && row.quality == turned
        };
        let mut rows: Vec<&Row> = trade.rows.iter().filter(is_turned).collect();
        rows.sort_by_key(|row| row.quality.square);
        let points = rows
            .iter()
            .map(|row| (row.quality.square as f64, row.psnr_db));
        Series {
            name: name.to_owned(),
            points: points.collect(),
            labels: rows
                .iter()
                .map(|row| format!("{:.1}x", row.speedup))
                .collect(),
            has_line: true,
        }
    };
    let bases = [("thesis", Quality::THESIS), ("default", Quality::DEFAULT)];
    Chart {
        x: "side of the largest square, pixels",
        y: PSNR,
        legend: MiddleRight,
        series: bases.into_iter().map(series).collect(),
    }
}

/// The plot of some curves.
fn curves(curves: &[Curve], x: &'static str, legend: SeriesLabelPosition) -> Chart {
    let series = curves.iter().map(|curve| Series {
        name: curve.name.clone(),
        points: curve.points.clone(),
        labels: Vec::new(),
        has_line: true,
    });
    Chart {
        x,
        y: SPEED_UP,
        legend,
        series: series.collect(),
    }
}
