//! Draws charts as SVG.

use crate::bitmap::{INK, register_fonts, text};
use crate::output;
use anyhow::Result;
use plotters::coord::Shift;
use plotters::coord::combinators::{BindKeyPoints, IntoLogRange, LogCoord, WithKeyPoints};
use plotters::coord::ranged1d::{AsRangedCoord, ValueFormatter};
use plotters::prelude::*;
use plotters::style::FontStyle;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::ops::Range;
use std::path::Path;

/// The width and height of a chart, in units of the SVG.
const SIZE: (u32, u32) = (960, 600);
/// The width of the legend beside a chart, in units.
const LEGEND: u32 = 130;
/// The width of a legend with a list under it.
const LIST: u32 = 330;

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

/// A chart with two axes, a legend, and a list under the legend. The horizontal axis is logarithmic.
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
    label: &'static str,
    range: Range<f64>,
    /// Those of a logarithmic scale; none of a linear one, whose ticks are round numbers.
    ticks: Vec<f64>,
}

/// A series of points in one colour.
pub struct Series {
    /// The name in the legend.
    pub name: String,
    pub colour: RGBColor,
    pub points: Vec<(f64, f64)>,
    pub has_line: bool,
    /// The radius of the points' marks.
    pub mark: u32,
}

impl Axis {
    /// A linear axis that contains all values.
    pub fn linear(label: &'static str, values: impl Iterator<Item = f64>) -> Self {
        let (low, high) = range(values);
        let room = (0.05 * (high - low)).max(0.5);
        Self {
            label,
            // What is never below 0 begins there.
            range: (low - room).max(low.min(0.0))..high + room,
            ticks: Vec::new(),
        }
    }

    /// A logarithmic axis that contains all values, with those of the given ticks that are there. All have to be above 0.
    pub fn log(
        label: &'static str,
        values: impl Iterator<Item = f64>,
        mut ticks: Vec<f64>,
    ) -> Self {
        let (low, high) = range(values);
        let range = low / 1.15..high * 1.15;
        ticks.retain(|tick| range.contains(tick));
        Self {
            label,
            range,
            ticks,
        }
    }

    /// A logarithmic axis for the chart library.
    fn log_scale(&self) -> WithKeyPoints<LogCoord<f64>> {
        let scale = self.range.clone().log_scale();
        scale.with_key_points(self.ticks.clone())
    }
}

/// The text beside a tick.
fn tick(value: &f64) -> String {
    // Without the error of rounding.
    let value = (value * 1e6).round() / 1e6;
    if value >= 1e6 {
        format!("{} M", (value / 1e5).round() / 10.0)
    } else if value >= 1e4 {
        format!("{} k", (value / 1e2).round() / 10.0)
    } else {
        value.to_string()
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
        area.draw_text(&self.title, &text(20, FontStyle::Bold), (0, 0))?;
        area.draw_text(&self.note, &normal(13), (0, 28))?;
        let (_, rest) = area.split_vertically(50);
        let room = if self.list.is_empty() { LEGEND } else { LIST };
        let (chart, beside) = rest.split_horizontally(rest.dim_in_pixel().0 - room);
        if self.y.ticks.is_empty() {
            self.draw_chart(&chart, self.y.range.clone())?;
        } else {
            self.draw_chart(&chart, self.y.log_scale())?;
        }
        self.draw_legend(&beside)?;
        Ok(area.present()?)
    }

    fn draw_chart<Y: AsRangedCoord<Value = f64>>(&self, area: &Area<'_>, y: Y) -> Result<()>
    where
        Y::CoordDescType: ValueFormatter<f64>,
    {
        let mut chart = ChartBuilder::on(area)
            .x_label_area_size(46)
            .y_label_area_size(60)
            .build_cartesian_2d(self.x.log_scale(), y)?;
        chart
            .configure_mesh()
            .bold_line_style(PALE)
            .light_line_style(TRANSPARENT)
            .axis_style(INK)
            .set_all_tick_mark_size(5)
            .label_style(normal(14))
            .axis_desc_style(normal(15))
            .x_desc(self.x.label)
            .y_desc(self.y.label)
            .x_label_formatter(&tick)
            .y_label_formatter(&tick)
            .draw()?;
        for series in &self.series {
            let points = series.points.iter().copied();
            let points = points.filter(|(x, y)| x.is_finite() && y.is_finite());
            let (colour, mark) = (series.colour, series.mark);
            if series.has_line {
                let style = colour.stroke_width(2);
                chart.draw_series(LineSeries::new(points.clone(), style))?;
            }
            chart.draw_series(points.map(|point| Circle::new(point, mark, colour.filled())))?;
        }
        for label in &self.labels {
            let (horizontal, vertical, offset) = if label.is_below {
                (HPos::Right, VPos::Top, (-5, 3))
            } else {
                (HPos::Left, VPos::Bottom, (5, -3))
            };
            let style = normal(12).pos(Pos::new(horizontal, vertical));
            let text = Text::new(label.text.clone(), offset, style);
            chart.draw_series([EmptyElement::at((label.x, label.y)) + text])?;
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

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

fn normal(size: u32) -> TextStyle<'static> {
    text(size, FontStyle::Normal)
}
