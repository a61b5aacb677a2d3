//! The plots of the results.

use super::Trade;
use super::curves::Curve;
use super::outcome::{Outcome, front_by_psnr};
use crate::arguments::edges;
use crate::plot::{Axis, COLOURS, Chart, DARK, GREY, Label, Series};
use anyhow::Result;
use eightfold_tracer::Quality;
use plotters::style::RGBColor;
use std::path::Path;

/// The most points of the front that are numbered, so that numbers do not cover each other; and all named qualities.
const LISTED: usize = 12;

const PSNR: &str = "PSNR against every pixel traced, dB";
const SPEED_UP: &str = "speed-up over exhaustive frames";

/// Writes all plots for which there are results.
pub fn write(folder: &Path, trade: &Trade) -> Result<()> {
    front(trade).write(folder, "front")?;
    squares(trade).write(folder, "squares")?;
    if ys(&trade.by_resolution).next().is_some() {
        resolution(trade).write(folder, "resolution")?;
    }
    if ys(&trade.by_objects).next().is_some() {
        objects(trade).write(folder, "objects")?;
    }
    Ok(())
}

/// The line under a title: what was measured, and how.
fn note(trade: &Trade) -> String {
    format!(
        "{} scene, {}x{}, {} frames, {}",
        trade.scene,
        trade.width,
        trade.height,
        trade.times.len(),
        way(trade),
    )
}

/// How frames were drawn.
fn way(trade: &Trade) -> String {
    format!(
        "{}, one thread, {} edges",
        trade.isa,
        edges(trade.antialias)
    )
}

/// Where a point is in the plot of the front.
fn position(row: &Outcome) -> (f64, f64) {
    (row.speedup, row.accuracy.psnr_db)
}

fn label((x, y): (f64, f64), text: String, is_below: bool) -> Label {
    Label {
        x,
        y,
        text,
        is_below,
    }
}

/// Whether a point is so near to a label that their texts would cover each other.
fn is_close(label: &Label, row: &Outcome) -> bool {
    let (x, y) = position(row);
    (label.x / x).ln().abs() < 0.05 && (label.y - y).abs() < 1.0
}

/// The plot of all points, with the Pareto front of time against PSNR numbered.
fn front(trade: &Trade) -> Chart {
    let front = front_by_psnr(&trade.points);
    // If the front has many points, every n-th is listed, and all named qualities.
    let every = front.len().div_ceil(LISTED).max(1);
    let is_listed = |&(i, row): &(usize, &&Outcome)| i.is_multiple_of(every) || row.is_named();
    let listed = front.iter().enumerate().filter(is_listed);
    let listed: Vec<&Outcome> = listed.map(|(_, row)| *row).collect();
    let mut labels: Vec<Label> = Vec::new();
    for (number, row) in (1..).zip(&listed) {
        // If two points are close, the number of the second one goes below it.
        let is_below = labels
            .last()
            .is_some_and(|last| is_close(last, row) && !last.is_below);
        labels.push(label(position(row), number.to_string(), is_below));
    }
    let is_on_front = |row: &Outcome| front.iter().any(|on| std::ptr::eq(*on, row));
    let off_front = |row: &&Outcome| row.is_named() && !row.is_exact() && !is_on_front(row);
    let named = trade.points.iter().filter(off_front);
    labels.extend(named.map(|row| label(position(row), row.name.clone(), true)));
    let points = |is: &dyn Fn(&Outcome) -> bool| {
        let rows = trade.points.iter().filter(|row| !row.is_exact() && is(row));
        rows.map(position).collect::<Vec<_>>()
    };
    let all = points(&|_| true);
    let dots = |name, colour, is: &dyn Fn(&Outcome) -> bool| Series {
        has_line: false,
        mark: 3,
        ..line(name, colour, points(is))
    };
    Chart {
        title: "What speed costs: every setting, and the Pareto front".to_owned(),
        note: note(trade)
            + "; the front is of settings that compare colours, objects and lights of corners",
        x: Axis::log(SPEED_UP, all.iter().map(|at| at.0), tenths()),
        y: Axis::linear(PSNR, all.iter().map(|at| at.1)),
        series: vec![
            dots("colours, objects, lights", GREY, &|row| row.keys),
            dots("colours alone", COLOURS[5], &|row| !row.keys),
            dots("named", DARK, &Outcome::is_named),
            line(
                "Pareto front",
                COLOURS[1],
                front.iter().map(|row| position(row)).collect(),
            ),
        ],
        labels,
        list: (1..)
            .zip(&listed)
            .map(|(number, row)| format!("{number}  {}", row.name))
            .collect(),
    }
}

/// The plot of the error by the side of the squares, for the rules of 2008 and the default quality.
fn squares(trade: &Trade) -> Chart {
    let of = |quality: Quality| {
        let same = |row: &&Outcome| {
            let Quality {
                square, antialias, ..
            } = row.quality;
            let turned = Quality {
                square,
                antialias,
                ..quality
            };
            square > 1 && row.quality == turned
        };
        let mut rows: Vec<&Outcome> = trade.points.iter().filter(same).collect();
        rows.sort_by_key(|row| row.quality.square);
        rows
    };
    let lines = [
        ("thesis", of(Quality::THESIS)),
        ("default", of(Quality::DEFAULT)),
    ];
    let position = |row: &Outcome| (row.quality.square as f64, row.accuracy.psnr_db);
    let all: Vec<(f64, f64)> = lines
        .iter()
        .flat_map(|(_, rows)| rows.iter().map(|row| position(row)))
        .collect();
    let labels = lines.iter().flat_map(|(name, rows)| {
        rows.iter().map(move |row| {
            let speed_up = format!("{:.1}x", row.speedup);
            label(position(row), speed_up, *name == "thesis")
        })
    });
    let series = lines.iter().map(|(name, rows)| {
        let points = rows.iter().map(|row| position(row));
        line(name, colour(name), points.collect())
    });
    Chart {
        title: "Error and speed by the side of the squares".to_owned(),
        note: format!(
            "{}; the numbers are speed-ups over exhaustive frames",
            note(trade)
        ),
        x: Axis::log(
            "side of the largest square, pixels",
            all.iter().map(|at| at.0),
            vec![2.0, 4.0, 8.0, 16.0, 32.0],
        ),
        y: Axis::linear(PSNR, all.iter().map(|at| at.1)),
        series: series.collect(),
        labels: labels.collect(),
        list: Vec::new(),
    }
}

fn resolution(trade: &Trade) -> Chart {
    let curves = &trade.by_resolution;
    Chart {
        title: "Speed by the size of the picture".to_owned(),
        note: format!("{} scene, {}", trade.scene, way(trade)),
        x: Axis::log("pixels of the picture", xs(curves), tenths()),
        y: Axis::linear(SPEED_UP, ys(curves).chain([0.0])),
        series: lines(curves),
        labels: Vec::new(),
        list: Vec::new(),
    }
}

fn objects(trade: &Trade) -> Chart {
    let curves = &trade.by_objects;
    let powers = (0..9).map(|power| f64::from(1 << power)).collect();
    Chart {
        title: "Time of a frame by the number of spheres".to_owned(),
        note: format!(
            "fields of small spheres, {}x{}, {}",
            trade.width,
            trade.height,
            way(trade)
        ),
        x: Axis::log("spheres", xs(curves), powers),
        y: Axis::log(
            "time / time of an exhaustive frame with one sphere",
            ys(curves),
            tenths(),
        ),
        series: lines(curves),
        labels: Vec::new(),
        list: Vec::new(),
    }
}

fn xs(curves: &[Curve]) -> impl Iterator<Item = f64> {
    let points = curves.iter().flat_map(|curve| &curve.points);
    points.map(|(x, _)| *x)
}

fn ys(curves: &[Curve]) -> impl Iterator<Item = f64> {
    let points = curves.iter().flat_map(|curve| &curve.points);
    points.map(|(_, y)| *y)
}

/// Ticks at 1, 2 and 5 times every power of ten in question.
fn tenths() -> Vec<f64> {
    let powers = (-4..8).map(|power| 10_f64.powi(power));
    powers
        .flat_map(|power| [power, 2.0 * power, 5.0 * power])
        .collect()
}

fn lines(curves: &[Curve]) -> Vec<Series> {
    let lines = curves.iter();
    lines
        .map(|curve| line(&curve.name, colour(&curve.name), curve.points.clone()))
        .collect()
}

/// The colour of a quality, the same in all plots.
fn colour(name: &str) -> RGBColor {
    match name {
        "exhaustive" => DARK,
        "thesis" => COLOURS[0],
        "default" => COLOURS[1],
        "finest" => COLOURS[2],
        _ => COLOURS[3],
    }
}

/// A line through marked points.
fn line(name: &str, colour: RGBColor, points: Vec<(f64, f64)>) -> Series {
    Series {
        name: name.to_owned(),
        colour,
        points,
        has_line: true,
        mark: 4,
    }
}
