//! The plots of the results.

use super::Trade;
use super::curves::Curve;
use super::outcome::{Outcome, front_by};
use crate::plot::{Axis, COLOURS, Chart, DARK, GREY, Label, Series};
use anyhow::Result;
use plotters::style::RGBColor;
use std::path::Path;

/// The most points of the front that are numbered, so that numbers do not cover each other; and all named qualities.
const LISTED: usize = 12;

const PSNR: &str = "PSNR against every pixel traced, dB";

/// A measure by which the points of a plot are rated.
struct Measure {
    /// The name of the plot's files.
    file: &'static str,
    axis: &'static str,
    of: fn(&Outcome) -> Option<f64>,
    /// Whether less of it is better; its axis is then logarithmic, without those that have none.
    is_error: bool,
}

const MEASURES: [Measure; 3] = [
    Measure {
        file: "front",
        axis: PSNR,
        of: |row| Some(row.psnr_db),
        is_error: false,
    },
    Measure {
        file: "front-flip",
        axis: "FLIP against every pixel traced, mean",
        of: |row| row.flip_mean,
        is_error: true,
    },
    Measure {
        file: "front-pops",
        axis: "pixels that pop, of a frame",
        of: |row| row.pops,
        is_error: true,
    },
];

/// Writes all plots for which there are results.
pub fn write(folder: &Path, trade: &Trade) -> Result<()> {
    for measure in &MEASURES {
        if trade.points.iter().any(|row| measure.has(row)) {
            cloud(trade, measure).write(folder, measure.file)?;
        }
    }
    squares(trade).write(folder, "squares")?;
    if ys(&trade.by_resolution).next().is_some() {
        resolution(trade).write(folder, "resolution")?;
    }
    if ys(&trade.by_objects).next().is_some() {
        objects(trade).write(folder, "objects")?;
    }
    over_time(trade).write(folder, "over-time")
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
    format!("{}, one thread, {} edges", trade.isa, trade.edges())
}

impl Measure {
    /// Where a point is in the plot.
    fn position(&self, row: &Outcome) -> (f64, f64) {
        (row.speedup, (self.of)(row).unwrap_or(f64::NAN))
    }

    /// Whether a point is in the plot: none without any error is.
    fn has(&self, row: &Outcome) -> bool {
        let is_there = |value: f64| value.is_finite() && (value > 0.0 || !self.is_error);
        !row.is_exact() && (self.of)(row).is_some_and(is_there)
    }

    fn axis(&self, values: impl Iterator<Item = f64>) -> Axis {
        if self.is_error {
            Axis::log(self.axis, values, tenths())
        } else {
            Axis::linear(self.axis, values, 8)
        }
    }

    /// Whether a point is so near to a label that their texts would cover each other.
    fn is_close(&self, label: &Label, row: &Outcome) -> bool {
        let (x, y) = self.position(row);
        let apart = if self.is_error {
            4.0 * (label.y / y).ln().abs()
        } else {
            (label.y - y).abs()
        };
        (label.x / x).ln().abs() < 0.05 && apart < 1.0
    }

    fn label(&self, row: &Outcome, text: String, is_below: bool) -> Label {
        let (x, y) = self.position(row);
        Label {
            x,
            y,
            text,
            is_below,
        }
    }
}

/// The plot of all points by a measure, with its front numbered.
fn cloud(trade: &Trade, measure: &Measure) -> Chart {
    let sign = if measure.is_error { 1.0 } else { -1.0 };
    let mut front = front_by(&trade.points, |row| sign * measure.position(row).1);
    front.retain(|row| measure.has(row));
    // If the front has many points, every n-th is listed, and all named qualities.
    let every = front.len().div_ceil(LISTED).max(1);
    let is_listed = |&(i, row): &(usize, &&Outcome)| i.is_multiple_of(every) || is_named(row);
    let listed = front.iter().enumerate().filter(is_listed);
    let listed: Vec<&Outcome> = listed.map(|(_, row)| *row).collect();
    let is_on_front = |row: &Outcome| front.iter().any(|on| std::ptr::eq(*on, row));
    let off_front = |row: &&Outcome| is_named(row) && measure.has(row) && !is_on_front(row);
    let mut labels: Vec<Label> = Vec::new();
    for (number, row) in (1..).zip(&listed) {
        // If two points are close, the number of the second one goes below it.
        let is_below = labels
            .last()
            .is_some_and(|last| measure.is_close(last, row) && !last.is_below);
        labels.push(measure.label(row, number.to_string(), is_below));
    }
    let named = trade.points.iter().filter(off_front);
    labels.extend(named.map(|row| measure.label(row, row.name.clone(), true)));
    let by = |is: &dyn Fn(&Outcome) -> bool| {
        let rows = trade.points.iter();
        let rows = rows.filter(|row| measure.has(row) && is(row));
        rows.map(|row| measure.position(row)).collect::<Vec<_>>()
    };
    let all = || by(&|_| true).into_iter();
    Chart {
        title: "What speed costs: every setting, and the Pareto front".to_owned(),
        note: note(trade)
            + "; the front is of settings that compare colours, objects and lights of corners",
        x: Axis::log(
            "speed-up over exhaustive frames",
            all().map(|(speedup, _)| speedup),
            tenths(),
        ),
        y: measure.axis(all().map(|(_, value)| value)),
        series: vec![
            series(
                "colours, objects, lights",
                GREY,
                by(&|row| row.keys),
                false,
                3,
            ),
            series("colours alone", COLOURS[5], by(&|row| !row.keys), false, 3),
            series("named", DARK, by(&is_named), false, 3),
            series(
                "Pareto front",
                COLOURS[1],
                front.iter().map(|row| measure.position(row)).collect(),
                true,
                4,
            ),
        ],
        labels,
        list: (1..)
            .zip(&listed)
            .map(|(number, row)| entry(number, row))
            .collect(),
    }
}

/// A line of the list beside the plot.
fn entry(number: usize, row: &Outcome) -> String {
    if is_named(row) {
        format!("{number}  {}: {}", row.name, row.dials)
    } else {
        format!("{number}  {}", row.dials)
    }
}

fn is_named(row: &Outcome) -> bool {
    row.name != row.dials
}

/// The plot of the error by the side of the squares, for the rules of 2008 and the default quality.
fn squares(trade: &Trade) -> Chart {
    let line = |quality: eightfold_tracer::Quality| {
        let same = |row: &&Outcome| {
            row.square > 1
                && row.guarded
                && row.tolerance_agreeing == quality.tolerance_agreeing
                && row.tolerance_differing == quality.tolerance_differing
                && row.tolerance_side == quality.tolerance_side
                && (row.key_depth, row.state_depth) == (quality.key_depth, quality.state_depth)
                && (row.depth, row.highlight) == (quality.depth, quality.highlight)
                && row.least_contribution == quality.least_contribution
        };
        let mut rows: Vec<&Outcome> = trade.points.iter().filter(same).collect();
        rows.sort_by_key(|row| row.square);
        rows
    };
    let (thesis, played) = (
        line(eightfold_tracer::Quality::THESIS),
        line(eightfold_tracer::Quality::DEFAULT),
    );
    let position = |row: &&Outcome| (row.square as f64, row.psnr_db);
    let labels = |rows: &[&Outcome], is_below| -> Vec<Label> {
        let label = |row: &&Outcome| Label {
            x: row.square as f64,
            y: row.psnr_db,
            text: format!("{:.1}x", row.speedup),
            is_below,
        };
        rows.iter().map(label).collect()
    };
    let all = || thesis.iter().chain(&played);
    let line = |name, rows: &[&Outcome]| {
        let colour = colour(name);
        series(name, colour, rows.iter().map(position).collect(), true, 4)
    };
    Chart {
        title: "Error and speed by the side of the squares".to_owned(),
        note: format!(
            "{}; the numbers are speed-ups over exhaustive frames; squares whose side is no power of two are filled pixel by pixel",
            note(trade)
        ),
        x: Axis::log(
            "side of the largest square, pixels",
            all().map(|row| row.square as f64),
            vec![2.0, 4.0, 8.0, 16.0, 32.0],
        ),
        y: Axis::linear(PSNR, all().map(|row| row.psnr_db), 8),
        series: vec![line("thesis", &thesis), line("default", &played)],
        labels: [labels(&thesis, true), labels(&played, false)].concat(),
        list: Vec::new(),
    }
}

fn resolution(trade: &Trade) -> Chart {
    let curves = &trade.by_resolution;
    Chart {
        title: "Speed by the size of the picture".to_owned(),
        note: format!("{} scene, {}", trade.scene, way(trade)),
        x: Axis::log("pixels of the picture", xs(curves), tenths()),
        y: Axis::linear(
            "speed-up over exhaustive frames",
            ys(curves).chain([0.0]),
            8,
        ),
        series: lines(curves, 4),
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
        series: lines(curves, 4),
        labels: Vec::new(),
        list: Vec::new(),
    }
}

fn over_time(trade: &Trade) -> Chart {
    let curves = &trade.over_time;
    let last = xs(curves).fold(1e-3, f64::max);
    Chart {
        title: "The error of each frame".to_owned(),
        note: note(trade),
        x: Axis::linear("seconds", xs(curves), 10).up_to(last),
        y: Axis::linear(PSNR, ys(curves), 8),
        series: lines(curves, 0),
        labels: Vec::new(),
        list: Vec::new(),
    }
}

fn xs(curves: &[Curve]) -> impl Iterator<Item = f64> {
    curves
        .iter()
        .flat_map(|curve| &curve.points)
        .map(|(x, _)| *x)
}

fn ys(curves: &[Curve]) -> impl Iterator<Item = f64> {
    curves
        .iter()
        .flat_map(|curve| &curve.points)
        .map(|(_, y)| *y)
}

/// Ticks at 1, 2 and 5 times every power of ten in question.
fn tenths() -> Vec<f64> {
    let powers = (-4..8).map(|power| 10_f64.powi(power));
    powers
        .flat_map(|power| [power, 2.0 * power, 5.0 * power])
        .collect()
}

fn lines(curves: &[Curve], mark: u32) -> Vec<Series> {
    let lines = curves.iter();
    lines
        .map(|curve| {
            series(
                curve.name,
                colour(curve.name),
                curve.points.clone(),
                true,
                mark,
            )
        })
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

fn series(
    name: &str,
    colour: RGBColor,
    points: Vec<(f64, f64)>,
    has_line: bool,
    mark: u32,
) -> Series {
    Series {
        name: name.to_owned(),
        colour,
        points,
        has_line,
        mark,
    }
}
