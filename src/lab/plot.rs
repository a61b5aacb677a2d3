//! Draws charts as SVG.

use crate::bitmap::{INK, register_fonts, text};
use crate::output;
use anyhow::Result;
use plotters::coord::Shift;
use plotters::coord::ranged1d::{DefaultFormatting, KeyPointHint, Ranged};
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use plotters::style::FontStyle;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::path::Path;

/// The width and height of a chart, in units of the SVG.
const SIZE: (u32, u32) = (960, 600);
/// The width of the legend beside a chart, in units.
const LEGEND: u32 = 130;
/// The width of a legend with a list under it.
const LIST: u32 = 210;

const PALE: RGBColor = RGBColor(225, 225, 225);
/// The colour of the reference.
pub const DARK: RGBColor = RGBColor(90, 90, 90);
/// Colours that people with colour blindness can distinguish, too (Okabe and Ito).
pub const COLOURS: [RGBColor; 6] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
];
/// The colour of points in the background.
pub const GREY: RGBColor = RGBColor(170, 170, 170);

/// A chart with two axes, a legend, and a list under the legend.
pub struct Chart {
    pub title: String,
    /// The line under the title.
    pub note: String,
    pub x: Axis,
    pub y: Axis,
    pub series: Vec<Series>,
    pub labels: Vec<Label>,
    /// The lines of text under the legend.
    pub list: Vec<String>,
}

/// A text beside a point of the chart.
#[derive(Clone)]
pub struct Label {
    pub x: f64,
    pub y: f64,
    pub text: String,
    /// Whether it is below the point and to its left, instead of above and to its right.
    pub is_below: bool,
}

/// An axis of a chart.
pub struct Axis {
    pub label: String,
    pub from: f64,
    pub to: f64,
    /// Whether the scale is logarithmic; `from` and `to` are then logarithms to base 10.
    pub is_log: bool,
    pub ticks: Vec<f64>,
}

/// A series of points in one colour.
pub struct Series {
    /// The name in the legend.
    pub name: String,
    pub colour: RGBColor,
    pub points: Vec<(f64, f64)>,
    pub has_line: bool,
    /// The radius of the points' marks; 0 for none.
    pub mark: u32,
}

impl Axis {
    /// A linear axis that contains all values, with about `most` steps of a round size.
    pub fn linear(label: &str, values: impl Iterator<Item = f64>, most: usize) -> Self {
        let (low, high) = range(values);
        let rough = ((high - low) / most as f64).max(1e-9);
        let power = 10_f64.powf(rough.log10().floor());
        let step = [1.0, 2.0, 5.0, 10.0]
            .map(|by| by * power)
            .into_iter()
            .find(|&step| step >= rough)
            .unwrap_or(rough);
        let (first, last) = ((low / step).floor(), (high / step).ceil().max(1.0));
        let ticks: Vec<f64> = (first as i64..=last as i64)
            .map(|i| i as f64 * step)
            .collect();
        Self {
            label: label.to_owned(),
            from: ticks[0],
            to: ticks[ticks.len() - 1].max(ticks[0] + step),
            is_log: false,
            ticks,
        }
    }

    /// The same axis, ending at `last`.
    pub fn up_to(self, last: f64) -> Self {
        Self { to: last, ..self }
    }

    /// A logarithmic axis that contains all values, with the given ticks. All have to be above 0.
    pub fn log(label: &str, values: impl Iterator<Item = f64>, ticks: Vec<f64>) -> Self {
        let (low, high) = range(values);
        Self {
            label: label.to_owned(),
            from: (low / 1.15).log10(),
            to: (high * 1.15).log10(),
            is_log: true,
            ticks,
        }
    }

    /// The coordinate of a value along the axis.
    fn coordinate(&self, value: f64) -> f64 {
        if self.is_log { value.log10() } else { value }
    }

    fn scale(&self) -> Scale {
        let ticks = self.ticks.iter().map(|&tick| self.coordinate(tick));
        Scale {
            range: (self.from..self.to).into(),
            ticks: ticks
                .filter(|tick| (self.from..=self.to).contains(tick))
                .collect(),
        }
    }

    /// The text at a coordinate of the axis.
    fn text(&self, coordinate: f64) -> String {
        let value = if self.is_log {
            10_f64.powf(coordinate)
        } else {
            coordinate
        };
        // Removes the rounding error of the logarithm.
        let value = (value * 1e6).round() / 1e6;
        if value >= 1e6 {
            format!("{} M", (value / 1e5).round() / 10.0)
        } else if value >= 1e4 {
            format!("{} k", (value / 1e2).round() / 10.0)
        } else {
            value.to_string()
        }
    }
}

fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let finite = values.filter(|value| value.is_finite());
    let (low, high) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    });
    if low > high { (1.0, 2.0) } else { (low, high) }
}

impl Chart {
    /// Writes `name.svg` into a folder.
    pub fn write(&self, folder: &Path, name: &str) -> Result<()> {
        register_fonts();
        let mut svg = String::new();
        let area = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
        self.draw(&area)?;
        drop(area);
        output::write(&folder.join(format!("{name}.svg")), svg.as_bytes())
    }

    fn draw(&self, area: &Area<'_>) -> Result<()> {
        area.fill(&WHITE)?;
        let area = area.margin(14, 10, 14, 20);
        area.draw_text(&self.title, &text(20, 1, FontStyle::Bold), (0, 0))?;
        area.draw_text(&self.note, &normal(13), (0, 28))?;
        let (_, rest) = area.split_vertically(50);
        let room = if self.list.is_empty() { LEGEND } else { LIST };
        let (chart, beside) = rest.split_horizontally(rest.dim_in_pixel().0 - room);
        self.draw_chart(&chart)?;
        self.draw_legend(&beside)?;
        Ok(area.present()?)
    }

    fn draw_chart(&self, area: &Area<'_>) -> Result<()> {
        let mut chart = ChartBuilder::on(area)
            .x_label_area_size(46)
            .y_label_area_size(60)
            .build_cartesian_2d(self.x.scale(), self.y.scale())?;
        chart
            .configure_mesh()
            .bold_line_style(PALE)
            .light_line_style(TRANSPARENT)
            .axis_style(INK)
            .set_all_tick_mark_size(5)
            .label_style(normal(14))
            .axis_desc_style(normal(15))
            .x_desc(self.x.label.as_str())
            .y_desc(self.y.label.as_str())
            .x_label_formatter(&|&x| self.x.text(x))
            .y_label_formatter(&|&y| self.y.text(y))
            .draw()?;
        for series in &self.series {
            let points = series.points.iter();
            let points: Vec<(f64, f64)> = points
                .filter(|(x, y)| x.is_finite() && y.is_finite())
                .map(|&(x, y)| (self.x.coordinate(x), self.y.coordinate(y)))
                .collect();
            let (colour, mark) = (series.colour, series.mark);
            if series.has_line {
                let style = colour.stroke_width(2);
                chart.draw_series(LineSeries::new(points.iter().copied(), style))?;
            }
            let marks = points.into_iter();
            chart.draw_series(marks.map(|point| Circle::new(point, mark, colour.filled())))?;
        }
        for label in &self.labels {
            let (horizontal, vertical, offset) = if label.is_below {
                (HPos::Right, VPos::Top, (-5, 3))
            } else {
                (HPos::Left, VPos::Bottom, (5, -3))
            };
            let style = normal(12).pos(Pos::new(horizontal, vertical));
            let point = (self.x.coordinate(label.x), self.y.coordinate(label.y));
            let text = Text::new(label.text.clone(), offset, style);
            chart.draw_series([EmptyElement::at(point) + text])?;
        }
        Ok(())
    }

    /// Draws the legend, and the list under it.
    fn draw_legend(&self, area: &Area<'_>) -> Result<()> {
        let mut y = 4;
        for series in &self.series {
            let corners = [(20, y), (32, y + 12)];
            area.draw(&Rectangle::new(corners, series.colour.filled()))?;
            area.draw_text(&series.name, &normal(13), (38, y + 1))?;
            y += 20;
        }
        y += 6;
        for line in &self.list {
            area.draw_text(line, &normal(12), (20, y))?;
            y += 15;
        }
        Ok(())
    }
}

/// An axis for the chart library, with explicit ticks.
struct Scale {
    range: RangedCoordf64,
    ticks: Vec<f64>,
}

impl Ranged for Scale {
    type ValueType = f64;
    type FormatOption = DefaultFormatting;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        self.range.map(value, limit)
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.ticks.clone()
    }

    fn range(&self) -> std::ops::Range<f64> {
        self.range.range()
    }
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

fn normal(size: u32) -> TextStyle<'static> {
    text(size, 1, FontStyle::Normal)
}
