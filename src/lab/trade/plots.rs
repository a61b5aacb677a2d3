use super::curves::Curve;
use super::{Trade, from_the_slowest};
use crate::output;
use crate::plot::{Chart, Series};
use crate::row::Row;
use crate::technique::Sampling;
use anyhow::Result;
use eightfold_tracer::{Preset, Quality};
use plotters::chart::SeriesLabelPosition::{self, *};
use std::path::Path;

const PSNR: &str = "dB to exhaustive";
const SPEED_UP: &str = "speed-up over exhaustive frames";

pub fn write(folder: &Path, trade: &Trade) -> Result<()> {
    let resolution = curves(&trade.by_resolution, "pixels of the picture", UpperLeft);
    let objects = curves(&trade.by_spheres, "small spheres", UpperRight);
    for (name, chart) in [
        ("front", front(trade)),
        ("squares", squares(trade)),
        ("resolution", resolution),
        ("objects", objects),
    ] {
        if !chart.series.is_empty() {
            let svg = chart.svg(&trade.heading)?;
            output::write(&folder.join(format!("{name}.svg")), svg.as_bytes())?;
        }
    }
    Ok(())
}

fn front(trade: &Trade) -> Chart {
    let is_named = |row: &&Row| row.name.parse::<Preset>().is_ok();
    let dots = |name: &str, rows: Vec<&Row>, has_labels: bool| {
        let labels = rows.iter().filter(|_| has_labels);
        Series {
            name: name.to_owned(),
            points: rows.iter().map(|row| (row.speedup, row.psnr_db)).collect(),
            labels: labels.map(|row| row.name.clone()).collect(),
            has_line: false,
        }
    };
    let is_rival = |row: &&Row| row.sampling != Sampling::Full;
    let inexact = trade.rows.iter().filter(|row| !row.is_exact());
    let (rivals, settings): (Vec<&Row>, Vec<&Row>) = inexact.partition(is_rival);
    let named = settings.iter().copied().filter(is_named).collect();
    Chart {
        x: SPEED_UP,
        y: PSNR,
        legend: LowerLeft,
        series: vec![
            dots("settings", settings, false),
            dots("Pareto front", from_the_slowest(&trade.rows), false),
            dots("named", named, true),
            dots("fewer pixels", rivals, true),
        ],
    }
}

/// The labels are speed-ups.
fn squares(trade: &Trade) -> Chart {
    let series = |(name, base): (&str, Quality)| {
        let is_varied = |row: &&Row| {
            let square = row.quality.square;
            square > 1 && row.quality == Quality { square, antialias: false, ..base }
        };
        let mut rows: Vec<&Row> = trade.rows.iter().filter(is_varied).collect();
        rows.sort_by_key(|row| row.quality.square);
        let point = |row: &&Row| (row.quality.square as f64, row.psnr_db);
        let label = |row: &&Row| format!("{:.1}x", row.speedup);
        Series {
            name: name.to_owned(),
            points: rows.iter().map(point).collect(),
            labels: rows.iter().map(label).collect(),
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

fn curves(curves: &[Curve], x: &'static str, legend: SeriesLabelPosition) -> Chart {
    let series = curves.iter().map(|curve| Series {
        name: curve.name.clone(),
        points: curve.points.clone(),
        labels: Vec::new(),
        has_line: true,
    });
    Chart { x, y: SPEED_UP, legend, series: series.collect() }
}
