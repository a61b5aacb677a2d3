//! Draws charts as SVG and PNG. The font comes with the program, so that the system needs none.

use crate::{output, picture};
use anyhow::{Result, anyhow};
use plotters::coord::Shift;
use plotters::coord::ranged1d::{DefaultFormatting, KeyPointHint, Ranged};
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{FontStyle, register_font};
use std::path::Path;
use std::sync::Once;

/// The width and height of a chart, in units of the SVG.
const SIZE: (u32, u32) = (960, 600);
/// Pixels of the PNG per unit, for high-resolution screens.
const PIXELS: u32 = 2;
/// Samples per pixel along each axis: the bitmap backend does not antialias.
const SAMPLES: u32 = 2;
/// The width of the legend beside a chart, in units.
const LEGEND: u32 = 130;
/// The width of a legend with a list under it.
const LIST: u32 = 210;

const INK: RGBColor = RGBColor(34, 34, 34);
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
    /// Writes `name.svg` and `name.png` into a folder.
    pub fn write(&self, folder: &Path, name: &str) -> Result<()> {
        register_fonts();
        let mut svg = String::new();
        let area = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
        self.draw(&area, 1).map_err(|error| anyhow!("{error}"))?;
        drop(area);
        output::write(&folder.join(format!("{name}.svg")), svg.as_bytes())?;

        let scale = PIXELS * SAMPLES;
        let (width, height) = (SIZE.0 * scale, SIZE.1 * scale);
        let mut rgb = vec![0; (3 * width * height) as usize];
        let area = BitMapBackend::with_buffer(&mut rgb, (width, height)).into_drawing_area();
        self.draw(&area, scale)
            .map_err(|error| anyhow!("{error}"))?;
        drop(area);
        let pixels = smoothed(&rgb, width as usize, SAMPLES as usize);
        let png = picture::png((SIZE.0 * PIXELS) as usize, &pixels)?;
        output::write(&folder.join(format!("{name}.png")), &png)
    }

    fn draw<DB: DrawingBackend>(
        &self,
        area: &DrawingArea<DB, Shift>,
        scale: u32,
    ) -> Result<(), DrawingAreaErrorKind<DB::ErrorType>> {
        area.fill(&WHITE)?;
        let area = area.margin(14 * scale, 10 * scale, 14 * scale, 20 * scale);
        area.draw_text(&self.title, &text(20, scale, FontStyle::Bold), (0, 0))?;
        area.draw_text(
            &self.note,
            &text(13, scale, FontStyle::Normal),
            at(0, 28, scale),
        )?;
        let (_, rest) = area.split_vertically(50 * scale);
        let room = if self.list.is_empty() { LEGEND } else { LIST };
        let (chart, beside) = rest.split_horizontally(rest.dim_in_pixel().0 - room * scale);
        self.draw_chart(&chart, scale)?;
        self.draw_legend(&beside, scale)?;
        area.present()
    }

    fn draw_chart<DB: DrawingBackend>(
        &self,
        area: &DrawingArea<DB, Shift>,
        scale: u32,
    ) -> Result<(), DrawingAreaErrorKind<DB::ErrorType>> {
        let mut chart = ChartBuilder::on(area)
            .x_label_area_size(46 * scale)
            .y_label_area_size(60 * scale)
            .build_cartesian_2d(self.x.scale(), self.y.scale())?;
        chart
            .configure_mesh()
            .disable_mesh()
            .axis_style(INK.stroke_width(scale))
            .set_all_tick_mark_size(5 * scale)
            .label_style(text(14, scale, FontStyle::Normal))
            .axis_desc_style(text(15, scale, FontStyle::Normal))
            .x_desc(self.x.label.as_str())
            .y_desc(self.y.label.as_str())
            .x_label_formatter(&|&x| self.x.text(x))
            .y_label_formatter(&|&y| self.y.text(y))
            .draw()?;
        self.draw_grid(&mut chart, scale)?;
        for series in &self.series {
            let points = series.points.iter();
            let points: Vec<(f64, f64)> = points
                .filter(|(x, y)| x.is_finite() && y.is_finite())
                .map(|&(x, y)| (self.x.coordinate(x), self.y.coordinate(y)))
                .collect();
            let (colour, mark) = (series.colour, series.mark * scale);
            if series.has_line {
                let style = colour.stroke_width(2 * scale);
                chart.draw_series(LineSeries::new(points.iter().copied(), style))?;
            }
            let marks = points.into_iter();
            chart.draw_series(marks.map(|point| Circle::new(point, mark, colour.filled())))?;
        }
        for label in &self.labels {
            let (horizontal, vertical, offset) = if label.is_below {
                (HPos::Right, VPos::Top, at(-5, 3, scale))
            } else {
                (HPos::Left, VPos::Bottom, at(5, -3, scale))
            };
            let style = text(12, scale, FontStyle::Normal).pos(Pos::new(horizontal, vertical));
            let point = (self.x.coordinate(label.x), self.y.coordinate(label.y));
            let text = Text::new(label.text.clone(), offset, style);
            chart.draw_series([EmptyElement::at(point) + text])?;
        }
        Ok(())
    }

    /// Draws the legend, and the list under it.
    fn draw_legend<DB: DrawingBackend>(
        &self,
        area: &DrawingArea<DB, Shift>,
        scale: u32,
    ) -> Result<(), DrawingAreaErrorKind<DB::ErrorType>> {
        let mut y = 4;
        for series in &self.series {
            let corners = [at(20, y, scale), at(32, y + 12, scale)];
            area.draw(&Rectangle::new(corners, series.colour.filled()))?;
            let style = text(13, scale, FontStyle::Normal);
            area.draw_text(&series.name, &style, at(38, y + 1, scale))?;
            y += 20;
        }
        y += 6;
        for line in &self.list {
            area.draw_text(line, &text(12, scale, FontStyle::Normal), at(20, y, scale))?;
            y += 15;
        }
        Ok(())
    }

    /// Draws a pale line at each tick.
    fn draw_grid<DB: DrawingBackend>(
        &self,
        chart: &mut Cartesian<'_, DB>,
        scale: u32,
    ) -> Result<(), DrawingAreaErrorKind<DB::ErrorType>> {
        let style = PALE.stroke_width(scale);
        let (x, y) = (&self.x, &self.y);
        let inside = |axis: &Axis, tick: f64| axis.from < tick && tick <= axis.to;
        let columns = x.ticks.iter().map(|&tick| x.coordinate(tick));
        let rows = y.ticks.iter().map(|&tick| y.coordinate(tick));
        let columns = columns
            .filter(|&tick| inside(x, tick))
            .map(|tick| PathElement::new([(tick, y.from), (tick, y.to)], style));
        let rows = rows
            .filter(|&tick| inside(y, tick))
            .map(|tick| PathElement::new([(x.from, tick), (x.to, tick)], style));
        chart.draw_series(columns.chain(rows))?;
        Ok(())
    }
}

type Cartesian<'a, DB> = ChartContext<'a, DB, Cartesian2d<Scale, Scale>>;

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

/// A text style of a size in units.
pub fn text(size: u32, scale: u32, style: FontStyle) -> TextStyle<'static> {
    let size = f64::from(size * scale);
    FontDesc::new(FontFamily::SansSerif, size, style).color(&INK)
}

fn at(x: i32, y: i32, scale: u32) -> (i32, i32) {
    (x * scale as i32, y * scale as i32)
}

/// Registers the font. This has to be called before any text is drawn.
pub fn register_fonts() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        for (style, font) in [
            (FontStyle::Normal, ttf_noto_sans::REGULAR),
            (FontStyle::Bold, ttf_noto_sans::BOLD),
        ] {
            let registered = register_font("sans-serif", style, font);
            assert!(registered.is_ok(), "the font is valid");
        }
    });
}

/// Reduces an RGB bitmap, `width` pixels wide: each `0x00RRGGBB` pixel of the result is the mean of `by` times `by` pixels.
pub fn smoothed(rgb: &[u8], width: usize, by: usize) -> Vec<u32> {
    let columns = width / by;
    let rows = rgb.len() / (3 * width * by);
    let mut pixels = Vec::with_capacity(columns * rows);
    for y in 0..rows {
        for x in 0..columns {
            let mut sums = [0_usize; 3];
            for v in 0..by {
                let start = 3 * ((y * by + v) * width + x * by);
                for rgb in rgb[start..start + 3 * by].chunks_exact(3) {
                    for (sum, &channel) in sums.iter_mut().zip(rgb) {
                        *sum += usize::from(channel);
                    }
                }
            }
            let [r, g, b] = sums.map(|sum| (sum / (by * by)) as u32);
            pixels.push(r << 16 | g << 8 | b);
        }
    }
    pixels
}
